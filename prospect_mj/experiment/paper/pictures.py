"""Which figures a reproduction has: their tables, and the pictures of these."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import pyarrow as pa

from prospect_mj.experiment.paper import figures
from prospect_mj.experiment.paper.bands import Floats
from prospect_mj.experiment.paper.figure_tables import actions_table, strategy_table
from prospect_mj.experiment.paper.figures import Heading, Mark
from prospect_mj.experiment.paper.live_check import LiveCheck
from prospect_mj.experiment.paper.optimum import BySide, Optimum
from prospect_mj.experiment.paper.report import LIVE
from prospect_mj.experiment.paper.reproduce_config import PRETRAIN, ReproduceConfig
from prospect_mj.experiment.paper.sample import Sample


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
        optimum: the best possible; pretraining shows the dominant side only.
        config: size of the reproduction.
        cap: where trials are cut off [actions].
    """
    of = f"mean of {config.runs} runs in sets of ten trials, 95 % band"
    yield _figure_5a(sample, optimum, of, cap)
    yield _figure_5b(sample, optimum, of, cap)
    yield from _figures_6(sample, optimum.optimal, of)


def live(check: LiveCheck, optimum: Optimum, cap: int) -> Picture:
    """Live runs on the band of recorded ones."""
    heading = Heading("Live physics against recorded", "means in sets of ten trials")
    png = figures.live(check.table, heading, cap, optimum.actions.mean, check.runs)
    return Picture(LIVE, check.table, png)


def _figure_5a(sample: Sample, optimum: Optimum, of: str, cap: int) -> Picture:
    mean, many = sample.mean.baseline, sample.resampled.baseline
    table = actions_table(
        mean, many, np.full(mean.actions.shape[1], optimum.actions.mean)
    )
    heading = Heading("Actions per trial without a dominant hand (figure 5a)", of)
    marks = [Mark(650, 2.4, "near-optimal at about 650")]
    return Picture("figure_5a", table, figures.actions(table, heading, cap, marks))


def _figure_5b(sample: Sample, optimum: Optimum, of: str, cap: int) -> Picture:
    mean, many = sample.mean.dominant, sample.resampled.dominant
    table = actions_table(
        mean, many, _optima(optimum.actions, mean.switch, mean.actions)
    )
    title = "Actions per trial with a dominant hand (figure 5b)"
    heading = Heading(title, of, PRETRAIN)
    marks = [
        Mark(250, 2.4, "about 250", (-26, -40)),
        Mark(PRETRAIN, 6.0, "over six"),
    ]
    return Picture("figure_5b", table, figures.actions(table, heading, cap, marks))


def _figures_6(sample: Sample, best: BySide, of: str) -> Iterator[Picture]:
    mean, many = sample.mean.dominant, sample.resampled.dominant
    # The right hand is the dominant one.
    for letter, word, tables, shaded in (
        ("a", "easy", (mean.easy, many.easy, best.right), "all trials easy"),
        (
            "b",
            "difficult",
            (mean.difficult, many.difficult, best.left),
            "no such trials",
        ),
    ):
        table = strategy_table(*tables)
        title = f"Strategies in {word} trials (figure 6{letter})"
        heading = Heading(title, of, PRETRAIN, f"pretraining: {shaded}")
        yield Picture(f"figure_6{letter}", table, figures.strategies(table, heading))


def _optima(optimum: BySide, switch: int, actions: Floats) -> Floats:
    """The best possible mean of each set; the dominant hand is the right one."""
    n_sets = actions.shape[1]
    return np.where(np.arange(n_sets) < switch, optimum.right, optimum.mean)
