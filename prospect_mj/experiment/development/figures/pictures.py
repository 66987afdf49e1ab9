"""Which figures the study has, by the name of their file."""

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from itertools import product
from textwrap import wrap

from prospect_mj.agent.failed_actions import RULES, FailedActions
from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.claims.unmet import unmet
from prospect_mj.experiment.development.figures import (
    crossed,
    found,
    haptics,
    intervals,
    portraits,
    shares,
    single_runs,
)
from prospect_mj.experiment.development.figures.rivals import learning_curves
from prospect_mj.experiment.development.figures.shares import Panel
from prospect_mj.experiment.development.haptics.haptics import HapticResults
from prospect_mj.experiment.development.haptics.touch import TOUCHES
from prospect_mj.experiment.development.study import causal, haptic_rows
from prospect_mj.experiment.development.study.learners import SHOWN
from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.development.study.pictures import jar_pictures
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.recording.recording import Recording

_BANDS = "share of each strategy in sets of ten trials; shade: 95 % band over runs"
_DOTTED = "dotted: optimal ones of the easy trials"
_NO_DOT = "no dot: never above 10 % of the difficult trials"
_UNMET = "criteria that are not met, or are undecided (?)"
_OF_CROSSED = (
    "trials until late (vermilion) and early corrections (green) are gone, triangle: "
    f"never; {_NO_DOT};\nbars: for how long early ones lead; blue: optimal ones in the "
    f"worst block of easy trials;\nbelow these: {_UNMET}"
)
_NARROW = 20
"""Width of a column with single runs [characters]."""


def pictures(results: Results, recording: Recording) -> Iterator[tuple[str, bytes]]:
    """The figures of the parts that were made, each with its name.

    Args:
        results: of the study.
        recording: of the standard world, for pictures of the jar.
    """
    if results.learners:
        yield "strategies", _strategies(results)
        kept = {_wrapped(one.row.name): one.population for one in results.singles}
        yield "sequences", single_runs.single_runs(kept)
    if results.causal:
        yield from _causal(results)
    if results.population:
        yield "population", _population(results)
    if results.worlds:
        yield "worlds", _worlds(results)
    if results.change:
        for world, rule in product(results.extent.changes, RULES):
            yield f"change_{world}_{rule}", _change(results, world, rule)
    if results.found is not None:
        yield "found", found.found(results.found, jar_pictures(recording))
    if results.haptics is not None:
        yield from _grasps(results.haptics)
    for world in dict.fromkeys(one.row.world for one in results.touches):
        yield f"haptics_strategies_{world}", _touches(results, world)
    if results.rivals is not None:
        rivals = results.rivals
        yield "rivals", learning_curves(rivals.curves, rivals.settings)


def _strategies(results: Results) -> bytes:
    rows = {(one.row.name, one.row.rule): one for one in results.learners}
    panels = [
        [Panel(name, rows[name, rule].development) for rule in RULES]
        for name in SHOWN
        if (name, RULES[0]) in rows
    ]
    of = f"{_BANDS}; {_DOTTED}\nleft: failed actions allowed; right: suppressed"
    return shares.shares("Strategies in difficult trials", of, panels)


def _wrapped(name: str) -> str:
    """A name in lines that a narrow column has room for."""
    return "\n".join(wrap(name, _NARROW))


def _causal(results: Results) -> Iterator[tuple[str, bytes]]:
    rows = {one.row.name: one for one in results.causal}
    yield (
        "causal",
        _singles([rows[one.name] for one in causal.single(results.settings)]),
    )
    yield "causal_splits", _splits(rows)
    yield "causal_labels", _labels(rows)


def _singles(rows: Sequence[Measured]) -> bytes:
    of = (
        "the discovery learner with one thing changed; dots: all runs, lines: 95 %\n"
        f"{_NO_DOT}; right: {_UNMET}"
    )
    measured = {one.row.name: one.measured for one in rows}
    return intervals.intervals(
        "What makes the order", of, measured, unmet=list(map(unmet, rows))
    )


def _splits(rows: Mapping[str, Measured]) -> bytes:
    return crossed.crossed(
        "Order of the splits, re-estimation and inertia",
        _OF_CROSSED,
        tuple(causal.ORDERS),
        causal.VALUES,
        causal.RATES,
        lambda order, values, rate: rows[causal.forced_name(order, values, rate)],
    )


def _labels(rows: Mapping[str, Measured]) -> bytes:
    names = {"td": "TD", "return": "return"}
    kinds = {f"{names[a]}, {b}": (a, b) for a in causal.LABELS for b in causal.CACHES}
    return crossed.crossed(
        "Labels, re-estimation and inertia",
        _OF_CROSSED,
        tuple(kinds),
        causal.VALUES,
        causal.RATES,
        lambda kind, values, rate: rows[
            causal.labelled_name(*kinds[kind], values, rate)
        ],
    )


def _population(results: Results) -> bytes:
    panels = [[Panel(one.row.name, one.development) for one in results.population]]
    title = "Populations of learners that differ: difficult trials"
    return shares.shares(title, f"{_BANDS}; {_DOTTED}", panels)


def _worlds(results: Results) -> bytes:
    # By learner: how little or much a world makes of it is what is to be seen.
    by_learner = sorted(results.worlds, key=lambda one: one.row.name)
    rows = {
        f"{one.row.name}, {one.row.world}": one.measured.measured for one in by_learner
    }
    of = f"failed actions suppressed; dots: all runs, lines: 95 % intervals\n{_NO_DOT}"
    return intervals.intervals("Worlds that look unlike each other", of, rows)


def _change(results: Results, world: str, rule: FailedActions) -> bytes:
    rows = {
        one.row.name: one.development
        for one in results.change
        if (one.row.then, one.row.rule) == (world, rule)
    }
    draw = partial(Panel, beside=False)
    panels = [
        [
            draw(f"{name}: formerly {trials}", rows[name], trials)
            for trials in ("difficult", "easy")
        ]
        for name in DEFAULTS
    ]
    title = f"After the world has changed: {world}; failed actions {rule}"
    return shares.shares(title, _BANDS, panels, "trial after the change")


def _grasps(results: HapticResults) -> Iterator[tuple[str, bytes]]:
    yield "haptics_portraits", portraits.portraits(results.grasps, results.models)
    yield "haptics_separation", haptics.separation(results.told)


def _touches(results: Results, world: str) -> bytes:
    shown = [one for one in results.touches if one.row.world == world]
    rows = {(one.row.name, one.row.touch): one.development for one in shown}
    panels = [
        [
            Panel(f"{name}, told: {touch}", rows[name, touch])
            for name in haptic_rows.FEELING
        ]
        for touch in TOUCHES
    ]
    title = f"Difficult trials of learners told more of a grasp, {world} jar"
    return shares.shares(title, f"{_BANDS}; {_DOTTED}", panels)
