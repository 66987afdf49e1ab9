"""The workbench: the torso before a presented jar, where skills are tried."""

from collections.abc import Sequence
from typing import Self

import numpy as np

from prospect_mj.actions.action import ControllerRun
from prospect_mj.actions.plan import Robot
from prospect_mj.checks import check_integer
from prospect_mj.closing import Closing
from prospect_mj.control.controller import Controller
from prospect_mj.episodes.episode import Episode, LookTaken
from prospect_mj.episodes.recorder import Moment, WatchedTask
from prospect_mj.errors import InvalidValue
from prospect_mj.recording.config import LARGEST_SEED
from prospect_mj.robot.names import SIDES, Side
from prospect_mj.robot.torso import Reading, Torso
from prospect_mj.skills import skill as skills
from prospect_mj.skills.sensors import Sensors, sensors, trajectory
from prospect_mj.skills.skill import Skill
from prospect_mj.skills.skill_run import SkillRun, skill_run
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings
from prospect_mj.task.presentation import Orientation, checked_orientation


class Workbench(Closing):
    """Runs skills on live physics, one at a time, and tells all that came of each.

    It simulates just what the environment does: the same presentations, look, actions
    and supervisor, with neither a learner nor a limit of actions. `Workbench.present`
    makes one with a jar on it. After `close` nothing can be asked of it any more.

    Args:
        settings: everything below the learner; None for the defaults.

    Attributes:
        task: where everything happens: it has the simulation, the supervisor and the
            robot's belief.
    """

    def __init__(self, settings: TaskSettings | None = None) -> None:
        """Compile the models and open the eyes; `reset` presents a jar.

        Raises:
            MissingFile: if a model or asset file is missing.
            RenderingUnavailable: if there is no OpenGL.
        """
        self.task = PickPlaceTask(settings)
        self._watched = WatchedTask(self.task)
        self._closed = False
        self._remember = self.task.runner.watcher
        self.task.runner.watcher = self._watch
        simulation = self.task.simulation
        self._torso = Torso(simulation.model, simulation.data)
        self._times: list[float] = []
        self._sensed: list[Sensors] = []

    @classmethod
    def present(
        cls, lid: Orientation, seed: int = 0, settings: TaskSettings | None = None
    ) -> Self:
        """Make a workbench with a jar on it; see `reset`."""
        bench = cls(settings)
        try:
            bench.reset(lid, seed)
        except BaseException:
            bench.close()
            raise
        return bench

    def reset(self, lid: Orientation, seed: int = 0) -> LookTaken:
        """Present a jar anew, with the arms at rest, and look at it.

        Args:
            lid: the side on which the lid lies, `left` or `right`.
            seed: of the jar's place and turn, the lamp and the cameras' noise.

        Raises:
            InvalidChoice: if the lid can't lie there.
            InvalidValue: if the seed is none, or the workbench is closed.
        """
        watched = self._open()
        check_integer("seed", seed, 0, LARGEST_SEED)
        watched.reset(checked_orientation(lid), np.random.default_rng(seed))
        return self.look

    def run(self, skill: Skill, side: Side | None = None) -> SkillRun:
        """Run a skill to its end.

        Args:
            skill: one of the six by its name, such as `grasp-left`, or a function that
                writes a plan of controllers over a `Robot`, or over a `Robot` and a
                side.
            side: the hand, for a function that takes one.

        Raises:
            InvalidChoice: if there is no such skill or side.
            InvalidValue: if there is no jar yet, the workbench is closed, the function
                writes no plan, or the plan leaves predicates that no trial gets to.
            UnforeseenEvent: if one of the six ends as the supervisor did not foresee.
        """
        _ = self.look  # without a jar there is nothing to do
        self._times, self._sensed = [], []
        action = skills.action_of(skill)
        if action is None:
            plan = skills.plan_of(skill, self.robot, side)
            outcome = self._open().follow(plan, skills.name_of(skill, side))
        elif side is None:
            outcome = self._open().execute(action)
        else:
            raise InvalidValue("side", side, f"none beside {action.label}")
        return self._ended(outcome.runs)

    def sense(self) -> Sensors:
        """What the robot senses now.

        Raises:
            InvalidValue: if the workbench is closed, as with all that follows.
        """
        return self._sensors(self._torso.read())

    @property
    def robot(self) -> Robot:
        """What plans are written over."""
        return self._open().task.runner.robot

    @property
    def look(self) -> LookTaken:
        """What the robot saw of the jar, with the pictures of both eyes.

        Raises:
            InvalidValue: if there is no jar yet.
        """
        return self._open().look

    @property
    def inserted(self) -> bool:
        """Whether the jar truly stands in the receptacle and no hand holds it."""
        return self._open().inserted

    def save(self) -> Moment:
        """Keep the present moment, to try something else from here later.

        Raises:
            InvalidValue: if there is no jar yet.
        """
        return self._open().save()

    def restore(self, moment: Moment) -> None:
        """Go back to a moment, bit by bit."""
        self._open().restore(moment)

    def episode(self) -> Episode:
        """All skills since the jar was presented, or since the last `restore`.

        `prospect_mj.replay` makes a Rerun recording or a video of it.
        """
        return self._open().episode()

    def close(self) -> None:
        """Close the eyes; closing again does nothing."""
        self._closed = True
        self._watched.close()

    def _open(self) -> WatchedTask:
        """The task, while it may be used.

        Raises:
            InvalidValue: if the workbench is closed.
        """
        if self._closed:
            raise InvalidValue("workbench", "closed", "an open one: make another")
        return self._watched

    @property
    def _now(self) -> float:
        """Simulated time [s]."""
        return float(self.task.simulation.data.time)

    def _sensors(self, reading: Reading) -> Sensors:
        arms = self._open().task.runner.arms
        hands = {side: arms[side].grasp_pose().wxyz_xyz for side in SIDES}
        return sensors(reading, hands)

    def _watch(self, controllers: Sequence[Controller], reading: Reading) -> None:
        """One control period: for the episode, and for the skill that runs."""
        self._remember(controllers, reading)
        self._times.append(self._now)
        self._sensed.append(self._sensors(reading))

    def _ended(self, results: tuple[ControllerRun, ...]) -> SkillRun:
        episode, last = self._open().episode(), self.sense()
        span = episode.actions[-1]
        times = np.array([*self._times, span.end]) - span.start
        rows = [*self._sensed, last]
        return skill_run(span, episode.signals, trajectory(times, rows), last, results)
