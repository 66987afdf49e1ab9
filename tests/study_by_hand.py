"""Results of a study of development in which every trial is made by hand."""

from functools import cache

import felt_by_hand
import numpy as np
import pyarrow as pa
from hand_made_runs import B, E, L, X, population
from small_study import SETTINGS

from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.haptics import ends
from prospect_mj.experiment.development.haptics.haptics import HapticResults
from prospect_mj.experiment.development.haptics.touch import BITS, CATEGORY, END
from prospect_mj.experiment.development.measures.development import Development
from prospect_mj.experiment.development.study import (
    abstract_rows,
    after,
    causal,
    haptic_rows,
    learners,
    looks,
    measured,
    world_rows,
)
from prospect_mj.experiment.development.study import population as spread
from prospect_mj.experiment.development.study.found import (
    CHOICE,
    Discovered,
    Range,
    Says,
)
from prospect_mj.experiment.development.study.ideal_outcomes import IdealOutcomes
from prospect_mj.experiment.development.study.measured import (
    Measured,
    MeasuredCurves,
    Told,
)
from prospect_mj.experiment.development.study.results import Results, Single
from prospect_mj.experiment.development.study.settings import FELT_WORLDS, Extent
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.haptics import ClusterSettings

RUNS, BLOCKS = 4, 30
INFANT = [[L] * 5] * 6 + [[E] * 5] * 8 + [[B] * 5] * 16
AT_ONCE = [[X] * 5] + [[B] * 5] * 29
LATE = [[L] * 5] * 10 + [[B] * 5] * 20
EXTENT = Extent(
    ("learners", "causal", "population", "worlds", "change", "found", "haptics")
)
LIKE = ("discovery", "suppressed"), ("replay", "suppressed")
"""Learners and rules that develop as infants do."""


@cache
def runs(kind):
    """A population of runs alike."""
    return population(
        [{"infant": INFANT, "late": LATE, "at once": AT_ONCE}[kind]] * RUNS
    )


@cache
def findings(kind):
    """What it comes to."""
    return Findings.of(runs(kind), np.random.default_rng(0), 20)


def told(row, kind):
    """A row that did so."""
    return Told(row, RUNS, findings(kind))


def shown(row, kind, measures=measured.MEASURES):
    """A row that did so, with fewer numbers."""
    development = Development(*findings(kind).development)
    numbers = {one.name: one.estimate(development) for one in measures}
    if row.then is None:
        numbers |= measured.single_runs(findings(kind).sequences, RUNS)
    return MeasuredCurves(
        Measured(row, RUNS, numbers, findings(kind).order), development
    )


def causal_row(row):
    """A row that does as infants do unless its values are inherited."""
    kind = "late" if row.settings.learner.revalue == "inherit" else "infant"
    numbers = dict(shown(row, kind).measured.measured)
    splits = {
        name: Interval(66, 60, 70, 0) for name in (measured.INSERTION, measured.GRASP)
    }
    return Measured(row, RUNS, numbers | splits, findings(kind).order)


def found():
    """Two features of a discovery learner, and weights of the others."""
    bins = np.arange(N_BINS)
    v = {
        "left": np.exp(-(((bins - 30) / 9) ** 2)),
        "right": np.exp(-(((bins - 60) / 9) ** 2)),
    }
    levels = np.where(bins < 45, 1.0, -1.0) * (np.abs(bins - 45) < 20)
    says = [
        Says("discovery", name, 3, levels) for name in ("insertion", "grasp", "swap")
    ]
    says += [
        Says(name, CHOICE, 3, v["left"] - v["right"]) for name in ("linear", "replay")
    ]
    return Discovered(
        v, says, [Range("grasp", 34, 36, 0, 0, 0.27), Range("swap", 9, 12, 70, 71, 0)]
    )


TOLD = {BITS: (0, "infant"), CATEGORY: (3, "late"), END: (2, "at once")}
"""Categories that a learner is told, and what it then does."""


def touches(settings=SETTINGS):
    """Learners that are told the hand, the category or the very end."""
    numbers = {touch: number for touch, (number, _) in TOLD.items()}
    rows = haptic_rows.rows(settings, dict.fromkeys(FELT_WORLDS, numbers))
    return [shown(row, TOLD[row.touch][1]) for row in rows]


def by_number(settings=SETTINGS):
    """The learner that is told categories of other numbers of models."""
    rows = haptic_rows.of_numbers(settings, dict.fromkeys(FELT_WORLDS, (2, 5)))
    return [shown(row, "infant") for row in rows]


@cache
def haptics():
    """Grasps whose ends feel unlike, and what tells them."""
    rng, two = np.random.default_rng(0), ClusterSettings(models=2, starts=2)
    grasps = {world: felt_by_hand.grasps(6, rng) for world in FELT_WORLDS}
    fits = {jar: ends.clustered(one, two, rng) for jar, one in grasps.items()}
    models = {jar: found.models for jar, found in fits.items()}
    told = [ends.told(jar, one, two, rng) for jar, one in grasps.items()]
    numbers = [
        ends.numbers(jar, one, {2: fits[jar]}, two, rng) for jar, one in grasps.items()
    ]
    return HapticResults(
        grasps, models, {}, pa.concat_tables(told), pa.concat_tables(numbers)
    )


def results(extent=EXTENT, settings=SETTINGS):
    """Of all parts but rivals."""
    made, parts = Results(settings, extent), extent.parts
    if "learners" in parts:
        for row in learners.rows(settings):
            kind = "infant" if (row.name, row.rule) in LIKE else "at once"
            made.learners.append(told(row, kind))
            if row.rule == "suppressed" and row.name in learners.SHOWN:
                made.singles.append(Single(row, runs(kind)))
        made.outcomes = IdealOutcomes(500, 0)
    if "causal" in parts:
        made.causal = [causal_row(row) for row in causal.rows(settings)]
    made.towards_abstract = [
        shown(row, "infant").measured
        for part in parts
        for row in abstract_rows.rows(settings, part)
    ]
    if "population" in parts:
        made.population = [told(row, "infant") for row in spread.rows(settings)]
    if "worlds" in parts:
        rows = world_rows.worlds(settings, extent.worlds)
        made.worlds = [shown(row, "infant") for row in rows]
        looked = [(w, 4, 0.8, 0.99, 0.15) for w in extent.worlds]
        made.looks = looks.LOOKS_SCHEMA.empty_table().from_pylist(
            [dict(zip(looks.LOOKS_SCHEMA.names, one, strict=True)) for one in looked],
            schema=looks.LOOKS_SCHEMA,
        )
    if "change" in parts:
        rows = world_rows.changes(settings, extent.changes)
        made.change = [shown(row, "late", after.MEASURES_AFTER) for row in rows]
        made.formerly_easy = list(map(after.of_formerly_easy, made.change))
    made.found = found() if "found" in parts else None
    if "haptics" in parts:
        made.haptics, made.touches = haptics(), touches(settings)
        made.by_number = by_number(settings)
    made.seconds = dict.fromkeys(parts, 1.5)
    return made
