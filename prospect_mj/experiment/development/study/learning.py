"""Lets the rows of the study learn, or reads what they did before."""

from collections.abc import Callable
from pathlib import Path

import pyarrow as pa

from prospect_mj.experiment.development.study.recordings import Recordings
from prospect_mj.experiment.development.study.rows import Row
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.experiment.populations.store import Kept, Look, Store
from prospect_mj.recording.worlds import STANDARD

FOLDER = "populations"
"""Of what the learners did, in that of the study."""

Tell = Callable[[str], object]


class Laboratory:
    """Where populations learn, and are kept.

    Args:
        folder: of the study.
        recordings: of all worlds.
        jobs: threads.
        tell: takes a line when a population is there.

    Attributes:
        recordings: as given.
        learning_seconds: wall time in which the populations learned that were asked
            for, in this command or an earlier one [s].
    """

    def __init__(
        self, folder: Path, recordings: Recordings, jobs: int, tell: Tell
    ) -> None:
        """Open the folder of populations.

        Raises:
            RunFolderError: if it can't be made.
        """
        self.recordings, self._jobs, self._tell = recordings, jobs, tell
        self._folder = folder / FOLDER
        self._stores = {
            world: Store(self._folder, recording, jobs)
            for world, recording in recordings.by_world.items()
        }
        self._others: list[Store] = []
        self.learning_seconds = 0.0

    def learned(self, row: Row, world: RecordedWorld | None = None) -> Population:
        """The population of a row.

        Args:
            row: it.
            world: what it begins in, with the categories that its learners are told;
                None: the recording of the row's world, without any.
        """
        then = None if row.then is None else self.recordings.by_world[row.then]
        store = self._stores[row.world] if world is None else self._open(world)
        kept = store.get(row.scenario, row.settings, then)
        self.learning_seconds += kept.seconds
        runs = len(kept.population.lid)
        when = ", kept" if kept.earlier else ""
        words = f"{row.part}: {row.title}: {runs} runs, {kept.seconds:.1f} s{when}"
        self._tell(words)
        return kept.population

    def rival(self, scenario: Scenario, settings: PopulationSettings) -> Kept:
        """A population of the standard world that is no row, and how long it took."""
        kept = self._stores[STANDARD].get(scenario, settings)
        self.learning_seconds += kept.seconds
        return kept

    def looked_into(
        self, scenario: Scenario, settings: PopulationSettings, look: Look
    ) -> pa.Table:
        """What is seen in learners of the standard world; see `Store.looked_into`."""
        runs, learner = settings.runs, settings.learner.name
        self._tell(f"looking into {runs} runs of {learner}")
        return self._stores[STANDARD].looked_into(scenario, settings, look)

    def unused(self) -> list[Path]:
        """What is kept in the folder of populations and nothing has asked for."""
        stores = (*self._stores.values(), *self._others)
        unused = [set(store.unused()) for store in stores]
        return sorted(set.intersection(*unused))

    def _open(self, world: RecordedWorld) -> Store:
        """The folder of populations, for those that begin in another world."""
        store = Store(self._folder, world, self._jobs)
        self._others.append(store)
        return store
