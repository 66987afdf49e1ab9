"""Live physics that trees grow on: made when it is needed, and anew when it failed."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from prospect_mj.closing import Closing
from prospect_mj.errors import RecordingError, SimulationDiverged, UnforeseenEvent
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.grower import Grower
from prospect_mj.recording.tree import Edge, OutcomeTree
from prospect_mj.task.presentation import Orientation


class LivePhysics(Closing):
    """Plants trees and extends them.

    Args:
        config: what the recording is of.
        make: makes what presents jars and runs actions.
    """

    def __init__(
        self,
        config: RecordingConfig,
        make: Callable[[RecordingConfig], Grower] = Grower,
    ) -> None:
        """Make nothing yet."""
        self._config, self._make = config, make
        self._grower: Grower | None = None

    @property
    def _live(self) -> Grower:
        if self._grower is None:
            self._grower = self._make(self._config)
        return self._grower

    def plant(self, orientation: Orientation, number: int) -> OutcomeTree:
        """Present a jar, look at it, and begin a tree.

        Raises:
            SimulationDiverged: if the physics is void.
            UnforeseenEvent: if the trial does not begin as the supervisor's model has
                it.
        """
        with self._renewed_if_it_fails(f"{orientation} {number}"):
            return self._live.plant(orientation, number)

    def extend(self, tree: OutcomeTree, edge: Edge) -> None:
        """Run an action from a node of a tree and add what it leads to.

        Raises:
            RecordingError: if the node's state is not known, or of another model.
            SimulationDiverged: if the physics is void.
            UnforeseenEvent: if what came of it is not in the supervisor's model.
        """
        place = f"{tree.orientation} {tree.number}, node {edge.node}"
        with self._renewed_if_it_fails(f"{place}, {edge.action.label}"):
            self._check_size(tree, edge.node, place)
            self._live.extend(tree, edge)

    def _check_size(self, tree: OutcomeTree, node: int, place: str) -> None:
        """Refuse a state that MuJoCo could not restore."""
        state = tree.nodes[node].state
        if state is None:
            return
        size = self._live.task.save().physics.size
        if state.physics.size != size:
            raise RecordingError(
                f"{place} is damaged: the state has {state.physics.size} numbers, and "
                f"the model {size}"
            )

    @contextmanager
    def _renewed_if_it_fails(self, place: str) -> Iterator[None]:
        """Name the place, and leave nothing of what went wrong behind."""
        try:
            yield
        except (SimulationDiverged, UnforeseenEvent) as error:
            # MuJoCo's warnings stay, whatever state is restored.
            self.close()
            error.args = (f"{place}: {error}",)
            raise
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Close the eyes, if there are any."""
        grower, self._grower = self._grower, None
        if grower is not None:
            grower.close()
