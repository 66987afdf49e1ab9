"""The study, part by part; what was made in an earlier command is read."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from time import perf_counter

from prospect_mj.experiment.development.haptics import haptics, touch
from prospect_mj.experiment.development.haptics.settings import HapticSettings
from prospect_mj.experiment.development.rivals import rivals
from prospect_mj.experiment.development.rivals.settings import RivalSettings
from prospect_mj.experiment.development.study import (
    abstract_rows,
    after,
    causal,
    found,
    haptic_rows,
    ideal_outcomes,
    learners,
    looks,
    measured,
    population,
    world_rows,
)
from prospect_mj.experiment.development.study.learning import Laboratory, Tell
from prospect_mj.experiment.development.study.measured import MeasuredCurves
from prospect_mj.experiment.development.study.recordings import Recordings
from prospect_mj.experiment.development.study.results import Results, Single
from prospect_mj.experiment.development.study.rows import Row
from prospect_mj.experiment.development.study.settings import (
    FELT_WORLDS,
    PARTS,
    Extent,
    Part,
    StudySettings,
)
from prospect_mj.experiment.paper.measures.measure import Measure
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.haptics import TrajectoryModels
from prospect_mj.recording.recording import Recording


class Study:
    """One study.

    Args:
        folder: where everything is kept.
        settings: its size.
        extent: which parts are made.
        recordings: of the worlds that these need.
        jobs: threads, and processes of what needs them.
        tell: takes a line for people now and then.
    """

    def __init__(
        self,
        folder: Path,
        settings: StudySettings,
        extent: Extent,
        recordings: Recordings,
        jobs: int,
        tell: Tell,
    ) -> None:
        """Open the folder of populations."""
        self._folder, self._settings, self._extent = folder, settings, extent
        self._recordings, self._jobs, self._tell = recordings, jobs, tell
        self._laboratory = Laboratory(folder, recordings, jobs, tell)
        self._results = Results(settings, extent, recordings.path, recordings.folder)

    def results(self) -> Results:
        """Make all parts, or read them."""
        made: dict[Part, Callable[[], None]] = {
            "learners": self._learners,
            "causal": self._causal,
            "population": self._population,
            "worlds": self._worlds,
            "change": self._change,
            "found": self._found,
            "haptics": self._haptics,
            "rivals": self._rivals,
        }
        seconds = {}
        for part in PARTS:
            if part in self._extent.parts:
                began = perf_counter()
                made[part]()
                seconds[part] = perf_counter() - began
                self._tell(f"{part}: {seconds[part]:.0f} s in all")
        self._results.seconds = seconds
        self._results.learning_seconds = self._laboratory.learning_seconds
        return self._results

    def unused(self) -> list[Path]:
        """Kept populations that nothing has asked for."""
        return self._laboratory.unused()

    def _learners(self) -> None:
        rows = learners.rows(self._settings)
        for number, row in enumerate(rows):
            learned = self._laboratory.learned(row)
            rng = self._settings.rng(PARTS.index("learners"), number)
            self._results.learners.append(measured.told(row, learned, rng))
            if row.rule == "suppressed" and row.name in learners.SHOWN:
                self._results.singles.append(Single(row, learned))
        self._results.outcomes = ideal_outcomes.compare(self._recordings.standard)
        self._towards_abstract("learners", len(rows))

    def _towards_abstract(self, part: Part, first: int) -> None:
        """Rows of a part from number `first`, with things of the abstract task."""
        made = abstract_rows.worlds(self._recordings.standard, self._settings)
        rows = abstract_rows.rows(self._settings, part)
        for number, row in enumerate(rows, first):
            made_up = row.world == abstract_rows.MADE_UP
            world = made[row.settings.learner.name] if made_up else None
            shown = self._shown(row, number, world=world)
            self._results.towards_abstract.append(shown.measured)

    def _causal(self) -> None:
        rows = causal.rows(self._settings)
        self._results.causal = [
            self._shown(row, number).measured for number, row in enumerate(rows)
        ]
        self._towards_abstract("causal", len(rows))

    def _population(self) -> None:
        for number, row in enumerate(population.rows(self._settings)):
            rng = self._settings.rng(PARTS.index("population"), number)
            learned = self._laboratory.learned(row)
            self._results.population.append(measured.told(row, learned, rng))

    def _worlds(self) -> None:
        names = self._extent.worlds
        self._results.looks = looks.table(self._recordings, names)
        rows = world_rows.worlds(self._settings, names)
        self._results.worlds = [
            self._shown(row, number) for number, row in enumerate(rows)
        ]

    def _change(self) -> None:
        rows = world_rows.changes(self._settings, self._extent.changes)
        self._results.change = [
            self._shown(row, number, after.MEASURES_AFTER)
            for number, row in enumerate(rows)
        ]
        changed = self._results.change
        self._results.formerly_easy = list(map(after.of_formerly_easy, changed))

    def _shown(
        self,
        row: Row,
        number: int,
        measures: tuple[Measure, ...] | None = None,
        world: RecordedWorld | None = None,
    ) -> MeasuredCurves:
        """A row's numbers and curves; with measures those after the change."""
        learned = self._laboratory.learned(row, world)
        rng = self._settings.rng(PARTS.index(row.part), number)
        if measures is None:
            return measured.measured(row, learned, rng)
        return measured.measured(row, after.from_the_change(learned), rng, measures)

    def _found(self) -> None:
        self._results.found = found.find(self._laboratory, self._settings)

    def _haptics(self) -> None:
        size = self._settings
        settings = HapticSettings(grasped=size.grasped, seed=size.seed)
        felt = {name: self._recordings.by_world[name] for name in FELT_WORLDS}
        found = haptics.run(self._folder, felt, settings, self._jobs, self._tell)
        worlds = {
            name: touch.worlds(recording, found.models[name])
            for name, recording in felt.items()
        }
        numbers = {
            name: {told: world.categories for told, world in told_worlds.items()}
            for name, told_worlds in worlds.items()
        }
        self._results.haptics = found
        rows = haptic_rows.rows(size, numbers)
        self._results.touches = [
            self._shown(row, number, world=worlds[row.world][row.touch])
            for number, row in enumerate(rows)
        ]
        self._by_number(felt, found.others, len(rows))

    def _by_number(
        self,
        felt: Mapping[str, Recording],
        others: Mapping[str, Mapping[int, TrajectoryModels]],
        first: int,
    ) -> None:
        """Rows of the part haptics from number `first`."""
        numbers = {world: others[world] for world in felt}
        for number, row in enumerate(
            haptic_rows.of_numbers(self._settings, numbers), first
        ):
            models = numbers[row.world][row.settings.categories]
            world = touch.worlds(felt[row.world], models)[row.touch]
            self._results.by_number.append(self._shown(row, number, world=world))

    def _rivals(self) -> None:
        size = self._settings
        settings = RivalSettings(
            linear_runs=size.runs,
            deep_runs=size.deep_runs,
            deep_trials=size.deep_trials,
            seed=size.seed,
            live_presentations=size.planned // 2,
        )
        if not size.planned:
            settings = replace(settings, live_errors=())
        self._results.rivals = rivals.run(
            self._folder,
            self._recordings.standard,
            settings,
            self._recordings.path,
            self._jobs,
            self._tell,
            self._laboratory.rival,
        )
