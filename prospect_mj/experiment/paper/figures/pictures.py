"""Which figures a reproduction has: their tables, and the pictures of these."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import pyarrow as pa

from prospect_mj.experiment.paper.figures import (
    actions_figure,
    captions,
    strategy_figure,
)
from prospect_mj.experiment.paper.figures.actions_figure import Mark
from prospect_mj.experiment.paper.figures.figure_frame import Heading
from prospect_mj.experiment.paper.figures.figure_tables import (
    actions_table,
    strategy_table,
)
from prospect_mj.experiment.paper.live.live_check import LiveCheck
from prospect_mj.experiment.paper.measures.bootstrap import LEVEL, Floats
from prospect_mj.experiment.paper.measures.sample import Sample
from prospect_mj.experiment.paper.reproduce_config import ReproduceConfig
from prospect_mj.experiment.populations.optimum import BySide, Optimum
from prospect_mj.experiment.populations.scenario import Scenario


class Picture(NamedTuple):
    """A figure and its numbers."""

    name: str
    table: pa.Table
    png: bytes


def published(
    sample: Sample, optimum: Optimum, config: ReproduceConfig, cap: int
) -> Iterator[Picture]:
    """The paper's figures 5 and 6.

    Args:
        sample: both scenarios.
        optimum: the best possible.
        config: size of the reproduction.
        cap: where trials are cut off [actions].
    """
    _, scenario = config.scenarios
    band = f"{100 * LEVEL:.0f} % band over runs, where wider than the line"
    of = f"mean of {config.runs} runs in sets of ten trials; shade: its {band}"
    yield _figure_5a(sample, optimum, of, cap)
    yield _figure_5b(sample, optimum, scenario, of, cap)
    yield from _figures_6(sample, optimum.optimal, scenario, of)


def live(check: LiveCheck, optimum: Optimum, cap: int) -> Picture:
    """Live runs on the band of recorded ones."""
    of = "mean actions in sets of ten trials without a dominant hand"
    heading = Heading(captions.TITLES[captions.LIVE], of)
    png = actions_figure.live(
        check.table, heading, cap, optimum.actions.mean, check.runs
    )
    return Picture(captions.LIVE, check.table, png)


def _figure_5a(sample: Sample, optimum: Optimum, of: str, cap: int) -> Picture:
    mean, many = sample.mean.baseline, sample.resampled.baseline
    best = np.full(mean.actions.shape[1], optimum.actions.mean)
    table = actions_table(mean, many, best)
    name = captions.FIGURE_5A
    marks = [Mark(650, "paper: nearly optimal\nafter about 650 trials")]
    heading = Heading(_title(name), of)
    png = actions_figure.actions(table, heading, cap, marks, optimum.exploring.mean)
    return Picture(name, table, png)


def _figure_5b(
    sample: Sample, optimum: Optimum, scenario: Scenario, of: str, cap: int
) -> Picture:
    mean, many = sample.mean.dominant, sample.resampled.dominant
    best = _optima(optimum.actions, scenario, mean.switch, mean.actions.shape[1])
    table = actions_table(mean, many, best)
    name, pretrain = captions.FIGURE_5B, scenario.pretrain
    marks = [
        Mark(250, "paper: approached\noptimality after\nabout 250 trials"),
        Mark(pretrain, "paper: over six", 6.0),
    ]
    heading = Heading(_title(name), of, pretrain)
    png = actions_figure.actions(table, heading, cap, marks, optimum.exploring.mean)
    return Picture(name, table, png)


def _figures_6(
    sample: Sample, best: BySide, scenario: Scenario, of: str
) -> Iterator[Picture]:
    mean, many = sample.mean.dominant, sample.resampled.dominant
    easy, difficult = _easy_and_difficult(best, scenario)
    for name, trials, once, drawn, best_share in (
        (captions.FIGURE_6A, "easy", mean.easy, many.easy, easy),
        (captions.FIGURE_6B, "difficult", mean.difficult, many.difficult, difficult),
    ):
        table = strategy_table(once.strategies, drawn.strategies, best_share)
        heading = Heading(_title(name), of, scenario.pretrain)
        yield Picture(name, table, strategy_figure.strategies(table, heading, trials))


def _title(name: str) -> str:
    """A figure's title, with its number in the paper."""
    return f"{captions.TITLES[name]} ({captions.words(name)})"


def _optima(optimum: BySide, scenario: Scenario, switch: int, n_sets: int) -> Floats:
    """The best possible mean of each set; all trials of the pretraining are easy."""
    easy, _ = _easy_and_difficult(optimum, scenario)
    return np.where(np.arange(n_sets) < switch, easy, optimum.mean)


def _easy_and_difficult(best: BySide, scenario: Scenario) -> tuple[float, float]:
    """The best possible where the lid is on the dominant hand's side, and elsewhere."""
    sides = best.left, best.right
    return sides if scenario.dominant == "left" else sides[::-1]
