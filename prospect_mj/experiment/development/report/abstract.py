"""How the recorded task differs from the abstract one that came before it, and why."""

from collections.abc import Iterator, Mapping

from prospect_mj.experiment.development.claims.criteria import CONFIDENT
from prospect_mj.experiment.development.report.abstract_numbers import (
    ABSTRACT,
    COMPARED,
    Compared,
    Key,
)
from prospect_mj.experiment.development.report.abstract_reasons import reasons
from prospect_mj.experiment.development.report.cells import order
from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.paper.report.markdown import table

_TASKS = """\
In the abstract task every action that can succeed does, and a histogram is one of two
made-up ones with noise in each bin: of cosine .95 with 30 % noise for its discovery
learner, of cosine .8 with 5 % for its linear and replay ones. The recorded one has what
{pictures} presentations led to in simulated contact, and pictures that a camera saw:
{found}.
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
    yield from reasons(results, compared)


def _tasks(results: Results) -> str:
    found = results.looks.to_pylist()[0]
    words = (
        f"the mean ones of both orientations have a cosine of {found['between']:.2f}, "
        f"and the noise of a bin is {100 * found['noise']:.0f} %"
    )
    return _TASKS.format(pictures=found["pictures"], found=words).rstrip()


def _table(rows: Mapping[Key, Measured]) -> str:
    head = ("learner", "rule", *(each.title for each in COMPARED), "order")
    lines = [
        (*key, *(_cell(each, key, one) for each in COMPARED), _orders(key, one, " / "))
        for key, one in rows.items()
    ]
    return table(head, lines)


def _cell(each: Compared, key: Key, one: Measured) -> str:
    words = f"{each.said_words(key)} / {each.found_words(one)}"
    return f"**{words}**" if each.differs(key, one) else words


def _orders(key: Key, one: Measured, between: str) -> str:
    return f"{order(ABSTRACT[key].order)}{between}{order(one.order)}"


def _order_differs(rows: Mapping[Key, Measured]) -> str:
    other = [
        f"*{', '.join(key)}* ({_orders(key, one, ', now ')})"
        for key, one in rows.items()
        if (ABSTRACT[key].order >= CONFIDENT) != (one.order >= CONFIDENT)
    ]
    if not other:
        return "The order of late and early corrections is the same in all of them."
    return f"The order of late and early corrections differs for {'; '.join(other)}."
