"""The report of the study, in Markdown."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from prospect_mj.experiment.development.report.abstract import abstract
from prospect_mj.experiment.development.report.causal import causal
from prospect_mj.experiment.development.report.command import command
from prospect_mj.experiment.development.report.elsewhere import (
    change,
    found,
    spread,
    worlds,
)
from prospect_mj.experiment.development.report.frame import closing, opening
from prospect_mj.experiment.development.report.haptics import haptics
from prospect_mj.experiment.development.report.learners import learners
from prospect_mj.experiment.development.report.rivals import rivals
from prospect_mj.experiment.development.study.found import MOST_RUNS
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.paper.measures.bootstrap import LEVEL, RESAMPLES
from prospect_mj.experiment.paper.report.markdown import table
from prospect_mj.recording.key import RecordingKey

_FEW = 20
"""Runs; of fewer, percentile intervals are too narrow."""


@dataclass(frozen=True)
class Made:
    """How the study was made."""

    results: Results
    keys: dict[str, RecordingKey]
    """Of the recordings, by the name of their world."""


def report(made: Made) -> str:
    """Write the report."""
    results = made.results
    sections = {
        "learners": learners,
        "causal": causal,
        "population": spread,
        "worlds": worlds,
        "change": change,
        "found": found,
        "haptics": haptics,
        "rivals": _rivals,
    }
    parts: list[Iterable[str]] = [_title(results), [opening(results)]]
    parts += [
        sections[part](results) for part in sections if part in results.extent.parts
    ]
    parts += [abstract(results), _how(made), closing(results)]
    return "\n\n".join(piece for part in parts for piece in part) + "\n"


def _title(results: Results) -> Iterator[str]:
    yield "# Development as in infants, on recorded physics"
    fewest = min(results.settings.fewer_runs, results.settings.runs)
    if fewest < _FEW:
        yield (
            f"A trial of the study: of as few runs as {fewest} intervals are too "
            "narrow, and verdicts worth nothing."
        )


def _rivals(results: Results) -> Iterator[str]:
    yield from rivals(results.rivals)
    yield command(results, "rivals")


def _how(made: Made) -> Iterator[str]:
    results, settings = made.results, made.results.settings
    yield "## How it was made"
    yield (
        f"Learners, populations and the rivals that are linear: {settings.runs} runs a "
        f"row, of which {min(settings.runs, MOST_RUNS)} are looked into for what was "
        "found; causal tables, worlds, changes and haptics: "
        f"{settings.fewer_runs} runs a row, whose intervals tell whether that is "
        "enough. Equal seeds in all rows: run k sees the same presentations in the "
        "same order in all of them that have the same pretraining. In brackets: "
        f"{100 * LEVEL:.0f} % intervals, percentiles of {RESAMPLES} resamples of the "
        "runs."
    )
    yield table(
        ("world", "key of the recording", "seed"),
        [
            (world, key.digest[:16], str(key.config.seed))
            for world, key in made.keys.items()
        ],
    )
    seconds = {**results.seconds, "all parts": sum(results.seconds.values())}
    yield table(
        ("part", "wall time in this command [s]"),
        [(part, f"{time:.0f}") for part, time in seconds.items()],
    )
    yield (
        "All populations, in this command or an earlier one, learned in "
        f"{results.learning_seconds:.0f} s of wall time."
    )
