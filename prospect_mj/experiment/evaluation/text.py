"""An evaluation's report for a terminal."""

from collections.abc import Iterable, Sequence
from itertools import groupby

from prospect_mj.experiment.evaluation.listing import Listed
from prospect_mj.experiment.evaluation.report import Outcome, Report
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.run.learning_curve import OPTIMUM
from prospect_mj.experiment.text_table import aligned
from prospect_mj.task.presentation import ORIENTATIONS

_NAMES = {**{side: f"lid {side}" for side in ORIENTATIONS}, "all": "all"}
_STRATEGIES = [strategy.name.lower() for strategy in Strategy]


def text(report: Report, longer: bool = False) -> str:
    """Lay a report out.

    Args:
        report: the figures.
        longer: whether solved trials that took more than the optimum are listed too.
    """
    head = ["", "trials", "solved, %", "actions per trial", *_STRATEGIES]
    rows = [_row(_NAMES[name], one) for name, one in report.outcomes.items()]
    lines = [
        f"greedy policy after {report.learned_trials} trials, {report.physics} physics",
        "",
        *aligned([head, *rows]),
        "in brackets 95 % intervals: Wilson's of shares, Student's of means",
        *_without_width(report.outcomes.values()),
        "",
        *_list("failures", report.failures),
    ]
    if longer:
        lines += ["", *_list(f"more than {OPTIMUM} actions", report.longer)]
    return "\n".join([*lines, "", f"evaluation folder: {report.path}"])


def _row(name: str, outcome: Outcome) -> list[str]:
    used = [str(outcome.strategies[strategy]) for strategy in _STRATEGIES]
    solved, actions = outcome.success.words(1, scale=100), outcome.actions.words(2)
    return [name, str(outcome.trials), solved, actions, *used]


def _without_width(outcomes: Iterable[Outcome]) -> list[str]:
    """What no interval can tell, where there is one of no width."""
    if all(one.actions.low < one.actions.high for one in outcomes):
        return []
    return ["intervals without width: no trials differed, which of few says little"]


def _list(title: str, trials: Sequence[Listed]) -> list[str]:
    if not trials:
        return [f"{title}: none"]
    lines = [f"{title}: {len(trials)}"]
    for one in trials:
        lines += [f"  trial {one.trial}, lid {one.orientation}: {_sequence(one)}"]
        lines += [f"    {one.replay}"]
    return lines


def _sequence(one: Listed) -> str:
    """Its actions, repetitions counted."""
    runs = [(words, len([*same])) for words, same in groupby(one.actions)]
    return ", ".join(words if n == 1 else f"{n} x {words}" for words, n in runs)
