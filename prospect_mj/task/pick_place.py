"""One trial of the task on live physics: present, look once, act."""

from dataclasses import dataclass, field
from typing import Literal, get_args

import numpy as np

from prospect_mj.actions.action import (
    Action,
    ActionOutcome,
    ActionResult,
    PlanOutcome,
)
from prospect_mj.actions.belief import Belief, SeenJar
from prospect_mj.actions.plan import Plan
from prospect_mj.actions.runner import ActionRunner
from prospect_mj.actions.workspace import workspace
from prospect_mj.checks import check_choice
from prospect_mj.closing import Closing
from prospect_mj.control.arm_control import GROSS_MOTIONS, GrossMotion
from prospect_mj.planning.settings import PlannerSettings
from prospect_mj.robot.names import Side
from prospect_mj.robot.torso import Torso
from prospect_mj.sim.camera import EyeSettings, StereoCamera, StereoPair
from prospect_mj.sim.scene import SceneSettings
from prospect_mj.sim.simulation import Simulation
from prospect_mj.supervisor.monitor import Monitor
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Mode, Supervisor
from prospect_mj.task.predicate_sensor import PredicateSensor
from prospect_mj.task.presentation import (
    Orientation,
    Presentation,
    PresentationSettings,
    draw_presentation,
)
from prospect_mj.task.scoring import is_inserted
from prospect_mj.task.trial_state import TrialState
from prospect_mj.vision.look import Look
from prospect_mj.vision.vision_controller import VisionController, VisionSettings

ObjectPose = Literal["vision", "truth"]


@dataclass(frozen=True)
class TaskSettings:
    """Everything below the learner."""

    supervisor: Mode = "none"
    """What the learner may choose from."""
    shaping: tuple[str, ...] = ()
    """Actions that it may not choose in the first trials, as `<action>:<trials>`."""
    object_pose: ObjectPose = "vision"
    """Where the controllers know the jar's first pose from; `truth` is an ablation."""
    gross_motion: GrossMotion = "harmonic"
    """How large movements go: along streamlines in configuration space, or, as an
    ablation, straight (`cartesian`)."""
    planning: PlannerSettings = field(default_factory=PlannerSettings)
    """Of the harmonic ones."""
    scene: SceneSettings = field(default_factory=SceneSettings)
    presentation: PresentationSettings = field(default_factory=PresentationSettings)
    eyes: EyeSettings = field(default_factory=EyeSettings)
    vision: VisionSettings = field(default_factory=VisionSettings)

    def __post_init__(self) -> None:
        """Refuse choices that are none, and a schedule that can't be."""
        check_choice("object pose", self.object_pose, get_args(ObjectPose))
        check_choice("gross motion", self.gross_motion, GROSS_MOTIONS)
        Supervisor(self.supervisor, self.shaping)


class PickPlaceTask(Closing):
    """The torso, the jar and the receptacle, with the six actions to try.

    Args:
        settings: everything below the learner.

    Attributes:
        simulation: the live physics.
        runner: runs the actions; holds the robot's belief.
        supervisor: decides which actions may run.
        monitor: follows each trial through the supervisor's automaton.
        camera: the stereo pair.
        vision: makes a look of an image pair.
        presentation: of the present trial; None before the first and after `restore`,
            as are the images and the look.
        images: what both eyes saw of it.
        look: what vision made of that.
    """

    def __init__(self, settings: TaskSettings | None = None) -> None:
        """Compile the models and open the eyes.

        Raises:
            MissingFile: if a model or asset file is missing.
            RenderingUnavailable: if there is no OpenGL.
        """
        self.settings = TaskSettings() if settings is None else settings
        self.simulation = Simulation(self.settings.scene)
        self.runner = ActionRunner(
            self.simulation, self.settings.gross_motion, self.settings.planning
        )
        self.supervisor = Supervisor(self.settings.supervisor, self.settings.shaping)
        self.monitor = Monitor()
        self._torso = Torso(self.simulation.model, self.simulation.data)
        places = workspace(self.settings.scene.props)
        self._sensor = PredicateSensor(self.runner.twin, places)
        self.camera = StereoCamera(self.simulation.model, self.settings.eyes)
        self.vision = VisionController(
            self.camera.left, self.camera.right, self.settings.vision
        )
        self.presentation: Presentation | None = None
        self.images: StereoPair | None = None
        self.look: Look | None = None

    def reset(self, orientation: Orientation, rng: np.random.Generator) -> Look:
        """Present the jar and look at it once.

        Args:
            orientation: the side on which the lid lies.
            rng: source of the presentation and of the sensor noise.

        Raises:
            UnforeseenEvent: if the arms are not at rest when the trial begins.
        """
        nominal = self.settings.scene.props.pedestal.nominal
        spread = self.settings.presentation
        presentation = draw_presentation(spread, nominal, orientation, rng)
        self.simulation.reset(presentation.placement, presentation.lamp_gain)
        images = self.camera.capture(self.simulation.data, rng)
        look = self.vision.look(images)
        self.runner.begin(Belief(seen=self._seen(look)))
        self.monitor.begin(self._observe())
        self.presentation, self.images, self.look = presentation, images, look
        return look

    def _seen(self, look: Look) -> SeenJar | None:
        """What the controllers get to know of the jar's pose."""
        if self.settings.object_pose == "truth":
            axis = self.simulation.jar_axis
            left = axis if axis[1] > 0 else -axis
            return SeenJar(self.simulation.jar_position, left)
        if look.position is None or look.axis is None:
            return None
        return SeenJar(look.position, look.axis)

    @property
    def holder(self) -> Side | None:
        """The hand whose grasp predicate is on."""
        return self.runner.belief.holding

    @property
    def predicates(self) -> PredicateState:
        """The predicates as they were last observed; the supervisor decides by them."""
        return self.monitor.predicates

    @property
    def inserted(self) -> bool:
        """Whether the jar stands in the receptacle and no hand holds it."""
        return self.holder is None and is_inserted(self.simulation)

    def execute(self, action: Action) -> ActionOutcome:
        """Run an action, or do nothing at all if the supervisor does not let it.

        Raises:
            UnforeseenEvent: if what came of it is not in the supervisor's model.
        """
        if self.supervisor.may_run(action, self.predicates):
            outcome = self.runner.execute(action)
        else:
            outcome = ActionOutcome(action, False, ActionResult.NOT_ALLOWED, 0.0)
        self.monitor.follow(action, outcome.result, self._observe())
        return outcome

    def follow(self, plan: Plan) -> PlanOutcome:
        """Run a plan that is none of the six actions, written over `runner.robot`.

        The supervisor's model doesn't know it, so that nothing is foreseen of it.

        Raises:
            InvalidValue: if it leaves predicates that no trial gets to.
        """
        outcome = self.runner.follow(plan)
        self.monitor.resume(self._observe())
        return outcome

    def save(self) -> TrialState:
        """The state of the trial, from which it can go on bit-identically."""
        belief = self.runner.belief.copy()
        return TrialState(self.simulation.save(), belief, self.predicates)

    def restore(self, state: TrialState) -> None:
        """Go on from a saved state, of any trial.

        The lamp is not part of it; no action depends on how bright it is.
        """
        self.simulation.restore(state.physics)
        self.runner.begin(state.belief.copy())
        self.monitor.resume(state.predicates)
        self.presentation, self.images, self.look = None, None, None

    def _observe(self) -> PredicateState:
        return self._sensor.observe(self._torso.read(), self.runner.belief)

    def close(self) -> None:
        """Close the eyes."""
        self.camera.close()
