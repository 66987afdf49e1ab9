"""What the comparison with rivals comes to."""

from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from prospect_mj.agent.failed_actions import RULES
from prospect_mj.experiment.development.figures.rivals import NAMES
from prospect_mj.experiment.development.rivals.planner.model_errors import FLIP, KINDS
from prospect_mj.experiment.development.rivals.rivals import (
    MAX_ACTIONS,
    RivalResults,
)
from prospect_mj.experiment.estimate import Estimate
from prospect_mj.experiment.paper.report.markdown import table

_LEARNERS = """\
All learn from the same recorded outcomes, both orientations from the first trial on, -1
an action and at most ten of them. Trials until near-optimal, a mean of at most 2.4
actions: *all runs*, as in the reproduction, until every set of ten trials has such a
mean over runs, which one unlucky set of few runs spoils; *smoothed*, until every moving
mean over five sets has, of {size} runs, so that many runs have no advantage: of those
who have more, the medians over groups of {size}; *single run*, until a run has had 50
such trials, the median over runs. In brackets: 95 % of resamples of the runs. A
resampled curve is rougher than that of the runs themselves, so that it settles rather
late. *Masked*, and MaskablePPO, choose from the supervisor's mode `productive`. The
deep learners have the libraries' settings but for a few, and were not tuned: another
rate, network or schedule may well do better. A linear learner's processor time is the
wall time of all runs by the threads they had.
"""

_PRICES = """\
What it takes to know the first action of a trial. The planner is told on which side the
lid lies and what the sizes are, which the learner finds out. *Steps* are goals taken
back through an operator, or situations expanded; *queries* are questions to geometry:
does an end fit, does a hand reach. *Simulated* are actions run in the exact model, with
the large movements planned for them and the inverse kinematics solved.
"""

_ERRORS = """\
Backward chaining with a wrong belief, carried out on recorded outcomes: mean actions of
a trial and, in brackets, the share that was not solved. It plans anew after every
action. Where failed actions are *allowed*, it does again what its model says must
succeed; where they are *suppressed*, it leaves out what has failed, and takes the jar's
ends to be the other way round where no plan remains.
"""

_LIVE = """\
Blind search in live physics whose receptacle is wider by the error on each side, its
plan carried out on recorded outcomes, in one presentation of each orientation. No plan:
no sequence of at most {depth} actions inserts the jar in the searched physics.
"""


def rivals(results: RivalResults) -> Iterator[str]:
    """The section, a piece at a time.

    Args:
        results: what came out.
    """
    yield "## Rivals on the same task"
    yield _LEARNERS.format(size=results.settings.deep_runs).rstrip()
    yield "![Learning curves of all learners](figures/rivals.png)"
    yield _learning(results)
    yield "### What a planner's decision costs"
    yield _PRICES.rstrip()
    yield _prices(results)
    yield "### Where a slightly wrong model breaks the plan"
    yield _ERRORS.rstrip()
    for kind in KINDS:
        yield _errors(results, kind)
    if results.live_errors.num_rows:
        yield _LIVE.format(depth=results.settings.depth).rstrip()
        yield _where_it_breaks(results)
        yield _live(results)


def _learning(results: RivalResults) -> str:
    size = results.settings.deep_runs
    head = "learner", "runs", "all runs", f"smoothed, {size} runs", "single run"
    rows = [
        (
            NAMES[row["agent"]],
            str(row["runs"]),
            _or_never(row["all_runs"]),
            _trials(row, "smoothed"),
            _trials(row, "single_run"),
            _last(row),
            f"{row['seconds_per_run']:.2g}",
        )
        for row in results.learning.to_pylist()
    ]
    return table((*head, "last 100 trials", "processor time of a run [s]"), rows)


def _trials(row: dict[str, float], name: str) -> str:
    low, high = (_or_never(row[f"{name}_{end}"]) for end in ("low", "high"))
    return f"{_or_never(row[name])} ({low} to {high})"


def _last(row: dict[str, float]) -> str:
    names = "last_actions", "last_low", "last_high"
    found = Estimate(*(row[name] for name in names))
    return found.within(1, MAX_ACTIONS).words(2)


def _or_never(trials: float) -> str:
    return f"{trials:.0f}" if np.isfinite(trials) else "never"


def _prices(results: RivalResults) -> str:
    names = {
        "actions": ".2f",
        "steps": ".1f",
        "queries": ".1f",
        "simulated": ".1f",
        "sim_seconds": ".0f",
        "motion_plans": ".0f",
        "ik_solutions": ".0f",
        "processor_seconds": ".2g",
    }
    head = (
        "method",
        "actions of the plan",
        "steps",
        "queries",
        "simulated",
        "simulated time [s]",
        "movements planned",
        "inverse kinematics",
        "processor time [s]",
    )
    rows = [
        (row["method"], *(_known(row[n], digits) for n, digits in names.items()))
        for row in results.prices.to_pylist()
    ]
    return table(head, rows)


def _known(value: float | None, digits: str) -> str:
    return "-" if value is None or np.isnan(value) else f"{value:{digits}}"


def _errors(results: RivalResults, kind: str) -> str:
    """One kind of error, a column for each rule for failed actions."""
    rows = [row for row in results.errors.to_pylist() if row["kind"] == kind]
    cells: dict[float, list[str]] = {}
    for row in rows:
        words = f"{row['actions']:.2f} ({100 * row['failures']:.0f} %)"
        cells.setdefault(row["error"], []).append(words)
    unit = "probability of the other side" if kind == FLIP else f"{kind}, error [mm]"
    sign = "g" if kind == FLIP else "+g"
    lines = [(f"{error:{sign}}", *words) for error, words in cells.items()]
    return table((unit, *RULES), lines)


def _where_it_breaks(results: RivalResults) -> str:
    """What came of the plans of wrong physics, and by which errors."""
    rows = results.live_errors.to_pylist()
    kinds = {
        "the plan inserts the jar in the world": [
            row for row in rows if row["inserted"]
        ],
        "it inserts the jar in the searched physics only": [
            row for row in rows if row["plan"] and not row["inserted"]
        ],
        "there is no plan": [row for row in rows if not row["plan"]],
    }
    return "\n".join(
        f"- {words}: {_by_error(found) or 'at no error'}"
        for words, found in kinds.items()
    )


def _by_error(rows: Iterable[Mapping[str, object]]) -> str:
    """The errors of some rows, with the orientation where only one is there."""
    lids: dict[float, list[str]] = {}
    for row in rows:
        lids.setdefault(row["error"], []).append(row["orientation"])
    return "; ".join(
        f"{error:+g} mm" + (f", lid {found[0]}" if len(found) == 1 else "")
        for error, found in lids.items()
    )


def _live(results: RivalResults) -> str:
    head = "error [mm]", "lid", "plan", "actions", "simulated", "simulated time [s]"
    return table((*head, "processor time [s]"), _live_rows(results))


def _live_rows(results: RivalResults) -> Iterator[tuple[str, ...]]:
    for row in results.live_errors.to_pylist():
        solved = "" if row["inserted"] else " (not solved)"
        yield (
            f"{row['error']:+g}",
            row["orientation"],
            row["plan"] or "none",
            f"{row['actions']}{solved}",
            str(row["simulated"]),
            f"{row['sim_seconds']:.0f}",
            f"{row['processor_seconds']:.1f}",
        )
