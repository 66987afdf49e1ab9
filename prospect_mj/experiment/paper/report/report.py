"""The report of a reproduction, in Markdown."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from prospect_mj.experiment.paper.ablation import choices
from prospect_mj.experiment.paper.figures.captions import FIGURES, words
from prospect_mj.experiment.paper.live.live_check import LiveCheck
from prospect_mj.experiment.paper.measures.bootstrap import LEVEL, RESAMPLES
from prospect_mj.experiment.paper.measures.sample import Sample
from prospect_mj.experiment.paper.measures.statements import Judgement
from prospect_mj.experiment.paper.report import (
    report_ablation,
    report_infants,
    report_live,
    report_statements,
)
from prospect_mj.experiment.paper.reproduce_config import (
    PRETRAIN,
    ReproduceConfig,
)
from prospect_mj.experiment.populations.optimum import Optimum
from prospect_mj.experiment.populations.speed import Speed
from prospect_mj.recording.key import RecordingKey

ABLATION, STATEMENTS = "ablation", "statements"
_FEW = 20
"""Runs; of ten, a 95 % interval covers the mean of a normal distribution in 90 %."""


@dataclass(frozen=True)
class Timing:
    """How long learning took."""

    seconds: float
    """Wall time of both scenarios, as they were computed [s]."""
    jobs: tuple[int, ...]
    """Threads that they had then, the same for both scenarios or not."""
    actions: int
    """That the learners took."""
    earlier: bool
    """Whether they were read from where an earlier command had put them."""
    speed: Speed
    """Of the compiled and the plain learner, measured for the report."""


@dataclass(frozen=True)
class Results:
    """All that a report tells."""

    config: ReproduceConfig
    key: RecordingKey
    """Of the recording."""
    changed: Sequence[str]
    """What decides outcomes and has changed since it was made, in words."""
    presentations: tuple[int, int]
    """Complete ones with the lid to the left, to the right."""
    optimum: Optimum
    sample: Sample
    judgements: Sequence[Judgement]
    rows: Sequence[choices.Row]
    live: LiveCheck | None
    timing: Timing


def report(results: Results) -> str:
    """Write the report."""
    sections = (
        _opening(results),
        report_statements.published(results.judgements),
        _figures(),
        report_statements.further(results.sample),
        report_infants.section(results.sample),
        report_ablation.section(results.rows, results.config.ablation.runs),
        report_live.section(results.live),
        _timing(results.timing),
    )
    return "\n\n".join(part for section in sections for part in section) + "\n"


def _opening(results: Results) -> Iterable[str]:
    config, best = results.config, results.optimum.actions
    left, right = results.presentations
    yield "# The paper's experiment on recorded physics"
    yield (
        f"{config.runs} runs in each of two scenarios, {config.trials} trials per run: "
        "without a dominant hand; and with one, where the pretraining is the first "
        f"{PRETRAIN} of these trials. Every "
        "outcome was simulated in full physics, and recorded, for "
        f"{left} presentations with the lid to the left and {right} with the lid to "
        f"the right. The best possible mean is {best.mean:.3f} actions per trial "
        f"({best.left:.3f} with the lid to the left, {best.right:.3f} to the right), "
        "computed from the recording by dynamic programming; of those who explore as "
        f"the learner does, {results.optimum.exploring.mean:.3f}."
    )
    yield _recording(results.key, results.changed)
    yield (
        f"In brackets: {100 * LEVEL:.0f} % intervals, percentiles of {RESAMPLES} "
        "resamples of the runs. The bands of figures 5 and 6 are made in the same way, "
        "set by set."
    )
    for where, runs in (("", config.runs), (" in the ablation", config.ablation.runs)):
        if runs < _FEW:
            yield f"Of {runs} runs{where} intervals of this kind are too narrow."


def _recording(key: RecordingKey, changed: Sequence[str]) -> str:
    """What was learned from."""
    versions = ", ".join(f"{name} {version}" for name, version in key.versions.items())
    now = f"Changes: {'; '.join(changed)}." if changed else "Nothing changed since."
    return (
        f"The recording: key {key.digest[:16]}, seed {key.config.seed}, "
        f"{key.config.gross_motion} gross motion, made with {versions}. {now}"
    )


def _figures() -> Iterable[str]:
    yield "## Figures"
    yield (
        f"Lines are means over runs, shades their {100 * LEVEL:.0f} % bands; where no "
        "shade is seen it is narrower than the line. What the paper states is marked "
        "as it says it: a trial by a line over all heights; a height that was "
        "exceeded, by an arrow upwards from it."
    )
    for name, title in FIGURES.items():
        yield f"![{title}]({name}.png)"
        yield f"*As the paper's {words(name)}. {title}. [Numbers]({name}.parquet).*"


def _timing(timing: Timing) -> Iterable[str]:
    yield "## Speed"
    plain = timing.actions / timing.speed.plain
    threads = " and ".join(map(str, timing.jobs))
    when = ", when an earlier command computed them" if timing.earlier else ""
    yield (
        f"Both scenarios, {timing.actions} actions, took {timing.seconds:.1f} s of "
        f"wall time (threads: {threads}){when}. On one thread the compiled learner "
        f"takes and learns from {timing.speed.kernel:.0f} actions per second, the "
        f"plain NumPy learner from {timing.speed.plain:.0f}: it would need "
        f"{plain:.0f} s for the same."
    )
