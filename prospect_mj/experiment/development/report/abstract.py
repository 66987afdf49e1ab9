"""How the recorded task differs from the abstract one that came before it, and why."""

from collections.abc import Iterator, Sequence

from prospect_mj.experiment.development.report.abstract_reasons import reasons
from prospect_mj.experiment.development.report.abstract_words import both, told_words
from prospect_mj.experiment.development.study.abstract_besides import Beside, besides
from prospect_mj.experiment.development.study.abstract_compared import COMPARED
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.tables import ABSTRACT
from prospect_mj.experiment.paper.report.markdown import table

_TASKS = """\
In the abstract task every action that can succeed does, and a histogram is one of two
made-up ones with noise in each bin: of cosine .95 with 30 % noise for its discovery
learner, of cosine .8 with 5 % for its linear and replay ones. The recorded one has what
{pictures} presentations led to in simulated contact, and pictures that a camera saw:
{found}.
"""

_COUNTED = """\
Rows that both tasks have: how many numbers are compared; how many of the abstract ones,
rounded as they are told, lie *outside* of the recorded interval; and how many *differ*,
beyond it by more than ten points, or than a tenth of a number of trials and a block of
ten. Three of the numbers are shown, the abstract one first, **bold** where they differ,
*slanted* where the abstract one is outside; `tables/{table}.parquet` has all. *-*: not
told.
"""

_SHOWN = COMPARED[:3]


def abstract(results: Results) -> Iterator[str]:
    """The section, a piece at a time."""
    rows = besides(results)
    if not rows:
        return
    yield "## How the recorded task differs from the abstract one"
    if results.looks is not None:
        yield _tasks(results)
    yield _COUNTED.format(table=ABSTRACT).rstrip()
    yield _table(rows)
    yield from reasons(results, rows)


def _tasks(results: Results) -> str:
    found = results.looks.to_pylist()[0]
    words = (
        f"the mean ones of both orientations have a cosine of {found['between']:.2f}, "
        f"and the noise of a bin is {100 * found['noise']:.0f} %"
    )
    return _TASKS.format(pictures=found["pictures"], found=words).rstrip()


def _table(rows: Sequence[Beside]) -> str:
    head = ("row", "numbers", "outside", "differ", *(each.title for each in _SHOWN))
    return table(head, [*map(_line, rows), _sum(rows)])


def _line(one: Beside) -> tuple[str, ...]:
    cells = [
        both(each, one) if each.is_told(one.told) else told_words(each, one.told)
        for each in _SHOWN
    ]
    return one.title, *map(str, _counts(one)), *cells


def _sum(rows: Sequence[Beside]) -> tuple[str, ...]:
    counts = map(sum, zip(*map(_counts, rows), strict=True))
    return "all", *map(str, counts), *("" for _ in _SHOWN)


def _counts(one: Beside) -> tuple[int, int, int]:
    return len(one.compared()), len(one.outside()), len(one.differing())
