"""How the recorded task differs from the abstract one that came before it.

The numbers of the abstract task are those of a rough study on a simulator without a
robot, with made-up histograms, whose code is gone ("Development feasibility", sections
3 and 4b); its blocks of ten trials are written as trials here.
"""

from collections.abc import Iterator, Mapping
from math import isnan, nan
from types import MappingProxyType
from typing import NamedTuple

from prospect_mj.experiment.development.report.cells import order
from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.quantity import Kind, number, with_interval
from prospect_mj.experiment.paper.report.markdown import table

_ALIKE = 0.1
"""A number is the same if it differs by a tenth of itself, or by one block of ten."""
_BLOCK = 10


class Abstract(NamedTuple):
    """What a row came to on the abstract task; NaN where it isn't told."""

    late_gone: float
    """[trials], NaN: never above 10 %."""
    early_gone: float
    order: float
    """[1]"""
    dominance: float
    """[trials]"""
    early_lead: float
    """[trials]"""
    optimal_last: float
    """[1]"""
    easy_worst: float
    """[1]"""


ABSTRACT: Mapping[tuple[str, str], Abstract] = MappingProxyType(
    {
        ("linear", "allowed"): Abstract(250, nan, 0.0, 20, 0, 0.97, 0.72),
        ("linear", "suppressed"): Abstract(350, nan, 0.0, 60, 0, 0.97, 0.95),
        ("linear, step .02", "allowed"): Abstract(90, 410, 0.98, 10, 0, 0.92, 0.77),
        ("linear, step .05", "allowed"): Abstract(50, 320, 1.0, 0, 0, 0.97, 0.62),
        ("linear, step .1", "allowed"): Abstract(30, 240, 1.0, 0, 0, 0.98, 0.47),
        ("linear, step .02", "suppressed"): Abstract(100, nan, 0, 20, 0, 0.98, 0.87),
        ("linear, step .05", "suppressed"): Abstract(50, 160, 1, 10, 0, 0.98, 0.68),
        ("replay", "allowed"): Abstract(30, 70, 1.0, 50, 40, 0.98, 0.97),
        ("replay", "suppressed"): Abstract(50, 100, 1.0, 80, 40, 0.98, 0.97),
        ("table", "suppressed"): Abstract(90, 100, 0.96, 0, 0, 0.98, 0.97),
        ("table, copied habit", "suppressed"): Abstract(
            130, nan, 0.0, 60, 0, 0.98, 0.97
        ),
        ("table, copied habit, replays", "suppressed"): Abstract(
            70, nan, 0.0, 60, 0, 0.98, 0.97
        ),
        ("table, copied habit, known correction", "suppressed"): Abstract(
            30, nan, 0.0, nan, 0, 0.98, nan
        ),
        ("table, copied habit, known correction, replays", "suppressed"): Abstract(
            50, 140, 1.0, nan, 80, 0.98, nan
        ),
        ("discovery", "allowed"): Abstract(60, 160, 1.0, 120, 90, 0.95, 0.83),
        ("discovery", "suppressed"): Abstract(80, 210, 1.0, 170, 100, 0.93, 0.81),
    }
)
"""By learner and rule."""

_TASKS = """\
The abstract task: every action that can succeed does, a histogram is one of two made-up
ones with noise in each bin, and a swap or a grasp has one outcome. The recorded one:
what {pictures} presentations led to in simulated contact, and pictures that a camera
saw: {found}. Its discovery learner had images of cosine .95 with 30 % noise, its linear
and replay ones of cosine .8 with 5 %.
"""


def abstract(results: Results) -> Iterator[str]:
    """The section, a piece at a time."""
    rows = {(one.row.name, one.row.rule): one.measured for one in results.learners}
    compared = {key: rows[key] for key in ABSTRACT if key in rows}
    if not compared:
        return
    yield "## How the recorded task differs from the abstract one"
    if results.looks is not None:
        yield _tasks(results)
    yield (
        "Abstract number, then the recorded one with its interval; **bold** where the "
        "abstract number lies outside of the interval by more than a tenth of itself "
        "and a block of ten trials, or ten points. *-*: not told."
    )
    yield _table(compared)
    yield _order_differs(compared)


def _tasks(results: Results) -> str:
    found = results.looks.to_pylist()[0]
    words = (
        f"the mean ones of both orientations have a cosine of {found['between']:.2f}, "
        f"and the noise of a bin is {100 * found['noise']:.0f} %"
    )
    return _TASKS.format(pictures=found["pictures"], found=words).rstrip()


def _table(rows: Mapping[tuple[str, str], Measured]) -> str:
    names = {
        "late_gone": ("late gone", Kind.TRIAL),
        "early_gone": ("early gone", Kind.TRIAL),
        "dominance": ("corrections dominate", Kind.TRIAL),
        "early_lead": ("early corrections lead", Kind.TRIAL),
        "optimal_last": ("optimal at the end", Kind.SHARE),
        "easy_worst": ("worst block of easy trials", Kind.SHARE),
    }
    head = ("learner", "rule", *(title for title, _ in names.values()), "order")
    lines = []
    for key, one in rows.items():
        said = ABSTRACT[key]
        cells = [
            _cell(getattr(said, name), one.measured[name], kind, "gone" in name)
            for name, (_, kind) in names.items()
        ]
        lines.append((*key, *cells, f"{order(said.order)} / {order(one.order)}"))
    return table(head, lines)


def _cell(said: float, found: Interval, kind: Kind, may_lack: bool) -> str:
    before = number(said, kind) if may_lack or not isnan(said) else "-"
    words = f"{before} / {with_interval(found, kind)}"
    return f"**{words}**" if _differs(said, found, kind, may_lack) else words


def _differs(said: float, found: Interval, kind: Kind, may_lack: bool) -> bool:
    if isnan(said) or isnan(found.estimate):
        return isnan(said) != isnan(found.estimate) and (may_lack or not isnan(said))
    reach = max(_ALIKE * said, _BLOCK) if kind is Kind.TRIAL else _ALIKE
    return not found.low - reach <= said <= found.high + reach


def _order_differs(rows: Mapping[tuple[str, str], Measured]) -> str:
    other = [
        f"*{', '.join(key)}* ({order(ABSTRACT[key].order)}, now {order(one.order)})"
        for key, one in rows.items()
        if (ABSTRACT[key].order >= 0.95) != (one.order >= 0.95)
    ]
    if not other:
        return "The order of late and early corrections is the same in all of them."
    return f"The order of late and early corrections differs for {'; '.join(other)}."
