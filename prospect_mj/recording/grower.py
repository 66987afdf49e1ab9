"""Growing outcome trees on live physics."""

import numpy as np

from prospect_mj.actions.action import ActionOutcome
from prospect_mj.closing import Closing
from prospect_mj.control.grasp_settings import GraspResult
from prospect_mj.errors import RecordingError
from prospect_mj.planning.settings import PlannerSettings
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.tree import Edge, Node, OutcomeTree, Shown
from prospect_mj.recording.worlds import WORLDS
from prospect_mj.sim.camera import EyeSettings
from prospect_mj.sim.scene import SceneSettings
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings
from prospect_mj.task.presentation import ORIENTATIONS, Orientation
from prospect_mj.vision.look import Look


def task_settings(config: RecordingConfig) -> TaskSettings:
    """Settings of the physics that a recording is made with."""
    harmonic, world = config.gross_motion == "harmonic", WORLDS[config.world]
    cells = PlannerSettings.with_cells(config.grid_cells)
    return TaskSettings(
        object_pose=config.object_pose,
        gross_motion=config.gross_motion,
        planning=cells if harmonic else PlannerSettings(),
        scene=SceneSettings(props=world.props),
        eyes=EyeSettings(noise_sd=world.noise_sd),
    )


def presentation_rng(
    config: RecordingConfig, orientation: Orientation, number: int
) -> np.random.Generator:
    """The chance of one presentation: its place, lamp and noise."""
    key = ORIENTATIONS.index(orientation), number
    return np.random.default_rng(np.random.SeedSequence(config.seed, spawn_key=key))


class Grower(Closing):
    """Presents jars and runs actions for one recording, on physics of its own.

    Args:
        config: what the recording is of.

    Attributes:
        task: the live physics.
    """

    def __init__(self, config: RecordingConfig) -> None:
        """Compile the models and open the eyes."""
        self._config = config
        self.task = PickPlaceTask(task_settings(config))

    def plant(self, orientation: Orientation, number: int) -> OutcomeTree:
        """Present a jar, look at it, and begin a tree."""
        rng = presentation_rng(self._config, orientation, number)
        look = self.task.reset(orientation, rng)
        root = Node(
            parent=None,
            action=None,
            executed=True,
            result=None,
            sim_seconds=0.0,
            predicates=self.task.predicates,
            inserted=self.task.inserted,
            depth=0,
            state=self.task.save(),
        )
        return OutcomeTree(orientation, number, self._shown(look), [root])

    def _shown(self, look: Look) -> Shown:
        presentation = self.task.presentation
        return Shown(
            position=tuple(presentation.placement.position.tolist()),
            yaw=float(presentation.placement.yaw),
            lamp_gain=float(presentation.lamp_gain),
            look=str(look.status),
            histogram=tuple(look.histogram.tolist()),
        )

    def extend(self, tree: OutcomeTree, edge: Edge) -> None:
        """Run an action from a node of a tree and add what it leads to.

        Raises:
            RecordingError: if the node's state is not known.
        """
        start = tree.nodes[edge.node]
        if start.state is None:
            raise RecordingError(
                f"presentation {tree.orientation} {tree.number} can't grow on: "
                "it was stored without states"
            )
        self.task.restore(start.state)
        tree.add(self._run(start, edge))

    def _run(self, start: Node, edge: Edge) -> Node:
        outcome = self.task.execute(edge.action)
        inserted = self.task.inserted
        grows_on = outcome.executed and not inserted
        return Node(
            parent=edge.node,
            action=edge.action,
            executed=outcome.executed,
            result=outcome.result,
            sim_seconds=outcome.sim_seconds,
            predicates=self.task.predicates,
            inserted=inserted,
            depth=start.depth + outcome.executed,
            state=self.task.save() if grows_on else None,
            felt=_felt(outcome),
        )

    def close(self) -> None:
        """Close the eyes."""
        self.task.close()


def _felt(outcome: ActionOutcome) -> tuple[tuple[float, float], ...]:
    """The trajectory of an action's last grasp, in single precision."""
    results = [run.result for run in outcome.runs]
    grasps = [result for result in results if isinstance(result, GraspResult)]
    if not grasps:
        return ()
    samples = np.array(grasps[-1].trajectory, np.float32).reshape(-1, 2)
    return tuple((seconds, eps) for seconds, eps in samples.tolist())
