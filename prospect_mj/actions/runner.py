"""Run a plan on the live simulation: the loop from sensors to servos."""

from collections.abc import Callable, Sequence

import numpy as np

from prospect_mj.actions.action import (
    Action,
    ActionOutcome,
    ActionResult,
    ControllerRun,
    PlanOutcome,
)
from prospect_mj.actions.belief import Belief
from prospect_mj.actions.grasp import grasp
from prospect_mj.actions.held import felt_jar
from prospect_mj.actions.insert import insert
from prospect_mj.actions.plan import Plan, Robot, ended
from prospect_mj.actions.swap import swap
from prospect_mj.actions.workspace import workspace
from prospect_mj.control.arm_control import GrossMotion, arm_control
from prospect_mj.control.controller import CONTROL_PERIOD, Controller
from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.planning.settings import PlannerSettings
from prospect_mj.robot.names import SIDES, Side
from prospect_mj.robot.torso import Reading, Torso
from prospect_mj.sim.simulation import Simulation

Watcher = Callable[[Sequence[Controller], Reading], None]
"""Told in every control period, before the physics goes on, which controllers were
updated with which reading; must not change either."""

_PLANS: dict[Action, tuple[Callable[[Robot, Side], Plan], Side]] = {
    Action.GRASP_LEFT: (grasp, "left"),
    Action.GRASP_RIGHT: (grasp, "right"),
    Action.SWAP_LEFT_TO_RIGHT: (swap, "left"),
    Action.SWAP_RIGHT_TO_LEFT: (swap, "right"),
    Action.INSERT_LEFT: (insert, "left"),
    Action.INSERT_RIGHT: (insert, "right"),
}


class ActionRunner:
    """Executes plans on a simulation, first of all the six actions.

    Args:
        simulation: the live physics.
        gross_motion: how large movements go: `harmonic` along streamlines in
            configuration space, `cartesian` straight, as an ablation.
        planning: settings of the harmonic ones.

    Attributes:
        twin: the kinematic twin that all controllers share.
        arms: the kinematics of both arms.
        belief: what the robot knows of the jar in this trial.
        watcher: see `Watcher`; None: nobody watches.
    """

    def __init__(
        self,
        simulation: Simulation,
        gross_motion: GrossMotion = "harmonic",
        planning: PlannerSettings | None = None,
    ) -> None:
        """Build the twin, both arms' inverse kinematics and their planners."""
        self._simulation = simulation
        self._torso = Torso(simulation.model, simulation.data)
        self._substeps = simulation.substeps(CONTROL_PERIOD)
        self.twin = KinematicTwin(simulation.settings)
        self.arms = {
            side: arm_control(side, self.twin, gross_motion, planning) for side in SIDES
        }
        props = simulation.settings.props
        self._workspace = workspace(props)
        self._nominal = props.pedestal.nominal
        self.belief = Belief()
        self.watcher: Watcher | None = None

    def begin(self, belief: Belief) -> None:
        """Start a trial with what the first look told, or go on with another belief."""
        self.belief = belief
        self.twin.update(self._torso.read())
        if belief.cradle is None:
            self.twin.place_pedestal(self._nominal, 0.0)
        else:
            x, y, _ = belief.cradle.axis
            yaw = float(np.arctan2(-x, y))
            self.twin.place_pedestal(belief.cradle.position, yaw)

    @property
    def robot(self) -> Robot:
        """What a plan is written over, with what the robot believes at present."""
        return Robot(self.arms, self.belief, self._workspace)

    def execute(self, action: Action) -> ActionOutcome:
        """Run an action to its end; whether it may run is the supervisor's affair.

        What comes of it follows from the simulation's saved state and the belief alone.
        """
        write, side = _PLANS[action]
        done = self.follow(write(self.robot, side))
        moved = done.result is not ActionResult.NOT_SEEN
        return ActionOutcome(action, moved, done.result, done.sim_seconds, done.runs)

    def follow(self, plan: Plan) -> PlanOutcome:
        """Run a plan to its end, one of the six actions or any other."""
        start = self._simulation.data.time
        self._simulation.refresh()
        runs: list[ControllerRun] = []
        self.twin.update(self._torso.read())
        while True:
            try:
                controllers = next(plan)
            except StopIteration as end:
                seconds = float(self._simulation.data.time - start)
                return PlanOutcome(end.value, seconds, tuple(runs))
            self._run(controllers)
            runs += [_record(controller) for controller in controllers]

    def _run(self, controllers: tuple[Controller, ...]) -> None:
        """Let controllers run at the same time until every one has a result."""
        while running := [c for c in controllers if c.result is None]:
            reading = self._torso.read()
            self.twin.update(reading)
            for controller in running:
                targets = controller.update(reading)
                arm = self._torso.arms[controller.side]
                if targets.joints is not None:
                    arm.command_joints(targets.joints)
                if targets.fingers is not None:
                    arm.command_fingers(targets.fingers)
            if self.watcher is not None:
                self.watcher(running, reading)
            self._simulation.step(self._substeps)
        self._feel()

    def _feel(self) -> None:
        """Sense where the joints are now, and how the jar sits in the hand."""
        reading = self._torso.read()
        self.twin.update(reading)
        for side, held in self.belief.held.items():
            touch, hand = reading[side].touch, self.arms[side].grasp_pose()
            if touch.found.all():
                jar = felt_jar(touch, hand @ held)
                self.belief.held[side] = hand.inverse() @ jar


def _record(controller: Controller) -> ControllerRun:
    name = type(controller).__name__
    return ControllerRun(name, controller.side, ended(controller))
