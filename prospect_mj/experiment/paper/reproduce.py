"""The paper's experiment from a recording to the report."""

import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.experiment.paper.ablation import ablation_table, choices
from prospect_mj.experiment.paper.figures import pictures
from prospect_mj.experiment.paper.figures.captions import LIVE
from prospect_mj.experiment.paper.live import live_check
from prospect_mj.experiment.paper.live.live_check import LiveCheck
from prospect_mj.experiment.paper.live.live_folders import FoundRuns, read_live
from prospect_mj.experiment.paper.measures import statements
from prospect_mj.experiment.paper.measures.sample import Resampling, Sample
from prospect_mj.experiment.paper.report.report import (
    ABLATION,
    STATEMENTS,
    Results,
    Timing,
    report,
)
from prospect_mj.experiment.paper.reproduce_config import ReproduceConfig
from prospect_mj.experiment.populations.digests import recording_digest
from prospect_mj.experiment.populations.optimum import optimum
from prospect_mj.experiment.populations.scenario import PopulationSettings
from prospect_mj.experiment.populations.speed import Speed, measured_speed
from prospect_mj.experiment.populations.store import Kept, Store
from prospect_mj.experiment.report_folder import REPORT, Kind, ReportFolder
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording

Tick = Callable[[], None]

POPULATIONS = "populations"
KIND = Kind("reproduction")
"""Of the folder: figures with their numbers beside them, and the populations."""


@dataclass(frozen=True)
class _Study:
    """What all steps need."""

    recording: Recording
    config: ReproduceConfig
    store: Store
    tick: Tick

    def learned(self, settings: PopulationSettings) -> tuple[Kept, Kept]:
        """The populations of both scenarios."""
        kept = []
        for scenario in self.config.scenarios:
            kept.append(self.store.get(scenario, settings))
            self.tick()
        return tuple(kept)


def n_steps() -> int:
    """Times that `reproduce` calls its tick."""
    return 2 * (1 + len(choices.variants()))


def reproduce(
    recording: Recording,
    config: ReproduceConfig,
    out: Path,
    jobs: int,
    live: Path | None = None,
    tick: Tick = lambda: None,
) -> Path:
    """Run the experiment, or what is left of it, and write the report.

    Args:
        recording: where outcomes and histograms come from.
        config: size of the experiment.
        out: new or empty folder, or one of the same reproduction.
        jobs: threads.
        live: folder of live runs to compare with, or None.
        tick: called after each population.

    Returns:
        The report's path.

    Raises:
        RecordingError: if the recording has too few complete presentations.
        RunFolderError: if `out` or `live` can't be used.
    """
    shown = _presentations(recording)
    found = _live_runs(live, config, recording)
    with ReportFolder.open(out, KIND, config, recording_digest(recording)) as folder:
        store = Store(out / POPULATIONS, recording, jobs)
        results = _results(_Study(recording, config, store, tick), shown, found)
        _write_figures(folder, results)
        folder.write_table(STATEMENTS, statements.table(results.judgements))
        folder.write_table(ABLATION, ablation_table.table(results.rows))
        folder.write(REPORT, report(results).encode())
        _clear(folder, store, results)
    return out / REPORT


def _results(study: _Study, shown: tuple[int, int], found: FoundRuns | None) -> Results:
    config, recording = study.config, study.recording
    settings = config.main
    speed = measured_speed(recording, config.scenarios[0], settings)
    # A stream for each, so that live runs or another table change nothing else.
    main, table, band = np.random.default_rng(config.seed).spawn(3)
    kept = study.learned(settings)
    sample = _sampled(kept, Resampling.draw(config.runs, main))
    return Results(
        config=config,
        key=recording.key,
        changed=recording.key.differences(RecordingKey.present(recording.key.config)),
        presentations=shown,
        optimum=optimum(recording, max_actions=settings.max_actions),
        sample=sample,
        judgements=statements.judge(sample),
        rows=list(_rows(study, table)),
        live=_compared(found, kept[0], band),
        timing=_timing(kept, speed),
    )


def _rows(study: _Study, rng: np.random.Generator) -> Iterator[choices.Row]:
    """One after the other, all with the same resamples of runs of the same seeds."""
    default = study.config.ablation
    resampling = Resampling.draw(default.runs, rng)
    for variant in choices.variants():
        settings = variant.settings(default)
        sample = _sampled(study.learned(settings), resampling)
        yield choices.measure_row(variant, settings == default, sample)


def _sampled(kept: tuple[Kept, Kept], resampling: Resampling) -> Sample:
    """Both populations' curves, resampled."""
    return Sample.of(*(one.population for one in kept), resampling)


def _timing(kept: tuple[Kept, Kept], speed: Speed) -> Timing:
    n_actions = sum(int(one.population.n_actions.sum(dtype=np.int64)) for one in kept)
    seconds = sum(one.seconds for one in kept)
    jobs = tuple(sorted({one.jobs for one in kept}))
    earlier = any(one.earlier for one in kept)
    return Timing(seconds, jobs, n_actions, earlier, speed)


def _presentations(recording: Recording) -> tuple[int, int]:
    """Complete presentations with the lid to the left, and to the right."""
    complete = recording.complete(PopulationSettings().max_actions)
    lids = recording.presentations.lid[complete]
    return tuple(int((lids == side).sum()) for side in (LEFT, RIGHT))


def _live_runs(
    live: Path | None, config: ReproduceConfig, recording: Recording
) -> FoundRuns | None:
    if live is None:
        return None
    return read_live(live, config.trials, config.main, recording.key)


def _compared(
    found: FoundRuns | None, recorded: Kept, rng: np.random.Generator
) -> LiveCheck | None:
    return None if found is None else live_check.check(found, recorded.population, rng)


def _write_figures(folder: ReportFolder, results: Results) -> None:
    cap = PopulationSettings().max_actions
    best = results.optimum
    made = list(pictures.published(results.sample, best, results.config, cap))
    if results.live is not None and results.live.runs:
        made.append(pictures.live(results.live, best, cap))
    for picture in made:
        folder.write_table(picture.name, picture.table)
        folder.write(f"{picture.name}.png", picture.png)


def _clear(folder: ReportFolder, store: Store, results: Results) -> None:
    """Leave nothing that the report doesn't tell of, but for what took time to make."""
    if results.live is None or not results.live.runs:
        folder.remove(f"{LIVE}.png")
        folder.remove(f"{LIVE}.parquet")
    if unused := store.unused():
        warnings.warn(
            f"{folder.path / POPULATIONS} has files of other code, settings or "
            f"versions, no longer read: {len(unused)}",
            stacklevel=3,
        )
