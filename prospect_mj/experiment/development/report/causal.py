"""What makes the order: the causal tables."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import product

from prospect_mj.experiment.development.claims.unmet import EXPLAINED, unmet
from prospect_mj.experiment.development.measures.measures import (
    dominance,
    early_gone,
    early_lead,
    early_most,
    easy_worst,
    late_gone,
    late_most,
    optimal_last,
)
from prospect_mj.experiment.development.report.cells import ORDER_TITLE, order
from prospect_mj.experiment.development.report.command import command
from prospect_mj.experiment.development.study.causal import (
    CACHES,
    LABELS,
    ORDERS,
    RATES,
    VALUES,
    forced_name,
    labelled_name,
    single,
)
from prospect_mj.experiment.development.study.measured import (
    GRASP,
    INSERTION,
    Measured,
)
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.paper.measures.quantity import Kind, number, with_interval
from prospect_mj.experiment.paper.report.markdown import table

_MEASURES = (
    late_gone,
    early_gone,
    dominance,
    early_lead,
    late_most,
    early_most,
    optimal_last,
    easy_worst,
)

_SINGLE = """\
The discovery learner, failed actions suppressed, with one thing changed. *Split*: the
trial after the pretraining in which the insertion, or the grasp, of the dominant hand
is first split by a feature, the median over runs (*never*: not in half of them).
"""

_CROSSED = """\
Each cell: trials until late, until early corrections are gone; the share of the
resamples in which the late ones are first; for how many trials on end corrections
exceed the optimal strategy with more early than late ones; and the worst block of easy
trials. **Bold**: as infants, by all criteria together; else *what is not met*, with a
question mark where it is undecided. Intervals are in
[measured.parquet](tables/measured.parquet).
"""

_UNMET = f"""\
*Not met*: which of the criteria for a development as in infants fail, or with a
question mark are undecided; none: as infants. {EXPLAINED}.
"""

_FORCED = """\
The contexts are split by the true orientation, insertions and all others each at a
trial of its own, {soon} or {later} trials after the pretraining. *Examples*: the values
of the leaves are estimated from remembered examples by what is known at present;
*stored*: by their targets as they were at the time; *inherit*: both leaves begin with
the value before. Columns: the least rate at which values follow, the inertia of habits.
"""

_LABELLED = """\
The learner finds its features itself. *td*: an example is better or worse by its
temporal-difference target, *return*: by all that the rest of its trial brought;
*surprising*: only what is far from the mean is remembered, *all*: everything. Splits
that are forced use no labels, so that these can't be crossed with the order above.
"""


def causal(results: Results) -> Iterator[str]:
    """The section, a piece at a time."""
    rows = {one.row.name: one for one in results.causal}
    soon, later = ORDERS["insertion first"]
    yield "## What makes the order"
    yield "![What makes the order](figures/causal.png)"
    yield "### One thing changed"
    yield _SINGLE.rstrip()
    yield _one_by_one([rows[one.name] for one in single(results.settings)])
    yield _UNMET.rstrip()
    yield "### Order of the splits, re-estimation and inertia"
    yield _FORCED.format(soon=soon, later=later).rstrip()
    yield _CROSSED.rstrip()
    yield "![Forced splits](figures/causal_splits.png)"
    yield _crossed(
        ("split first", "values"),
        RATES,
        product(ORDERS, VALUES),
        lambda names, rate: rows[forced_name(*names, rate)],
    )
    yield "### Labels, re-estimation and inertia"
    yield _LABELLED.rstrip()
    yield "![Labels](figures/causal_labels.png)"
    yield _crossed(
        ("labels", "remembered", "values"),
        RATES,
        product(LABELS, CACHES, VALUES),
        lambda names, rate: rows[labelled_name(*names, rate)],
    )
    yield command(results, "causal")


def _one_by_one(rows: Iterable[Measured]) -> str:
    titles = (one.title for one in _MEASURES)
    head = ("", "insertion split", "grasp split", *titles, ORDER_TITLE)
    return table((*head, "not met"), map(_cells, rows))


def _cells(one: Measured) -> tuple[str, ...]:
    splits = (with_interval(one.measured[n], Kind.TRIAL) for n in (INSERTION, GRASP))
    numbers = (with_interval(one.measured[m.name], m.kind) for m in _MEASURES)
    return one.row.name, *splits, *numbers, order(one.order), _lacking(one)


def _crossed(
    first: tuple[str, ...],
    rates: Iterable[float],
    lines: Iterable[tuple[str, ...]],
    row: Callable[[tuple[str, ...], float], Measured],
) -> str:
    """A table whose columns are rates, and whose lines are named by the others."""
    head = (*first, *(f"{rate:g}" for rate in rates))
    return table(
        head, [(*names, *(_brief(row(names, r)) for r in rates)) for names in lines]
    )


def _brief(one: Measured) -> str:
    found: Mapping[str, float] = {n: i.estimate for n, i in one.measured.items()}
    late, early, lead, easy = (
        number(found[measure.name], measure.kind)
        for measure in (late_gone, early_gone, early_lead, easy_worst)
    )
    words = f"{late}, {early}; {order(one.order)}; {lead}; {easy}"
    lacking = unmet(one)
    return f"{words}<br>*{', '.join(lacking)}*" if lacking else f"**{words}**"


def _lacking(one: Measured) -> str:
    return ", ".join(unmet(one)) or "none"
