"""Learners that differ, worlds that differ, a world that changes, what was found."""

from collections.abc import Iterator

from prospect_mj.agent.failed_actions import RULES, FailedActions
from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.development.report.cells import (
    cells,
    measured_table,
    titles,
)
from prospect_mj.experiment.development.report.command import command
from prospect_mj.experiment.development.report.learners import stages
from prospect_mj.experiment.development.study.after import (
    OF_A_KIND,
    again,
    difficult_errors,
    easy_errors,
    easy_last,
)
from prospect_mj.experiment.development.study.found import MOST_RUNS
from prospect_mj.experiment.development.study.population import SPREADS
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.world_rows import TRIALS_AFTER
from prospect_mj.experiment.paper.report.markdown import definitions, table
from prospect_mj.experiment.populations.spread import Spread

_OWN = (again, easy_errors, difficult_errors, easy_last)

_POPULATION = """\
Children differ, so each learner draws its own parameters here: {spreads}. Failed
actions are suppressed.
"""

_WORLDS = """\
Recordings of worlds that look unlike each other (`docs/worlds.md` tells what
they are). *Between*: cosine of the mean histograms of both orientations; *within*: of
two pictures of the same one; *noise*: of a bin, relative to its mean. In each of them
the learners begin anew; failed actions are suppressed.
"""

_CHANGE = """\
After the 1000 trials the standard world becomes another one, the same learner going on
for {trials} trials: *post*, where the lid must go down, so that the other end is the
right one to be held; *lamp-right*, where the same is right as before, and looks
different. Easy and difficult trials are those of before; a correction is one by what is
right now. All counts begin at the change.
"""

_FOUND = """\
Grey levels that the learners go by, of {runs} runs at most: features of the discovery
learner, signed so that blue speaks for the lid on the left, laid over the mean
histograms; weights of the linear learners, and the pixels of those levels in a picture
of the jar. A level is a hundredth of the range from its darkest to its brightest pixel.
"""


def spread(results: Results) -> Iterator[str]:
    """The population of learners that differ, a piece at a time."""
    told = "; ".join(
        f"*{name}*: {', '.join(map(_range, spreads))}"
        for name, spreads in SPREADS.items()
    )
    yield "## A population of learners that differ"
    yield _POPULATION.format(spreads=told).rstrip()
    yield "![Strategies in populations that differ](figures/population.png)"
    rows = [((one.row.name,), one.measured) for one in results.population]
    yield measured_table(("learner",), rows)
    yield stages(results.population)
    yield command(results, "population")


def worlds(results: Results) -> Iterator[str]:
    """Worlds that look unlike each other, a piece at a time."""
    yield "## Worlds that look unlike each other"
    yield _WORLDS.rstrip()
    head = ("world", "pictures", "between", "within", "noise")
    yield table(
        head,
        [
            (
                row["world"],
                str(row["pictures"]),
                *(f"{row[name]:.2f}" for name in head[2:]),
            )
            for row in results.looks.to_pylist()
        ],
    )
    yield "![Corrections by world](figures/worlds.png)"
    rows = [((one.row.world, one.row.name), one.measured) for one in results.worlds]
    yield measured_table(("world", "learner"), rows)
    yield command(results, "worlds")


def change(results: Results) -> Iterator[str]:
    """A world that changes, a piece at a time."""
    yield "## A world that changes"
    yield _CHANGE.format(trials=TRIALS_AFTER).rstrip()
    yield definitions(_OWN)
    for rule in RULES:
        yield f"### After a change, failed actions {rule}"
        for world in results.extent.changes:
            picture = f"figures/change_{world}_{rule}.png"
            yield f"![Strategies after the change, {world}, {rule}]({picture})"
        yield from _changed(results, rule)
    yield command(results, "change")


def _changed(results: Results, rule: FailedActions) -> Iterator[str]:
    """The tables of a rule."""
    both = zip(results.change, results.formerly_easy, strict=True)
    pairs = [(one, easy) for one, easy in both if one.row.rule == rule]
    head = "change to", "learner"
    names = [(one.row.then, one.row.name) for one, _ in pairs]
    difficult = [one.measured for one, _ in pairs]
    lines = zip(names, difficult, strict=True)
    yield table((*head, *titles(_OWN)), [(*of, *cells(one, _OWN)) for of, one in lines])
    yield "Of formerly difficult trials:"
    yield measured_table(head, zip(names, difficult, strict=True), OF_A_KIND)
    yield "Of formerly easy ones:"
    easy = [one for _, one in pairs]
    yield measured_table(head, zip(names, easy, strict=True), OF_A_KIND)


def found(results: Results) -> Iterator[str]:
    """What the learners discovered, a piece at a time."""
    yield "## What was discovered"
    yield _FOUND.format(runs=MOST_RUNS).rstrip()
    yield "![Grey levels that the learners go by](figures/found.png)"
    yield (
        "Features of the first run, as ranges of the "
        f"{N_BINS} levels from dark to bright:"
    )
    head = ("context", "level or range", "less", "cut-point")
    yield table(
        head,
        [
            (
                one.context,
                _levels(one.begin, one.end),
                _levels(one.less_begin, one.less_end),
                f"{one.cut:.3f}",
            )
            for one in results.found.example
        ],
    )
    yield command(results, "found")


def _levels(begin: int, end: int) -> str:
    if begin >= end:
        return "-"
    return str(begin) if end == begin + 1 else f"{begin} to {end - 1}"


def _range(one: Spread) -> str:
    how = " log-uniform" if one.logarithmic else ""
    return f"{one.parameter.replace('_', ' ')}{how} {one.low:g} to {one.high:g}"
