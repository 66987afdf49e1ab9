"""Every learner under both rules: measures, criteria, stages, single runs."""

from collections.abc import Iterator, Mapping, Sequence
from math import isnan

from prospect_mj.agent.failed_actions import RULES
from prospect_mj.experiment.development.claims.claim import Subject
from prospect_mj.experiment.development.claims.claims import asked, developing
from prospect_mj.experiment.development.claims.criteria import (
    LIKE_INFANTS,
    Criterion,
)
from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.claims.single_runs import OF_SINGLE_RUNS
from prospect_mj.experiment.development.measures.ages import AGES, AgeFound
from prospect_mj.experiment.development.measures.measures import MEASURES
from prospect_mj.experiment.development.measures.sequences import words
from prospect_mj.experiment.development.report.all_claims import by_row
from prospect_mj.experiment.development.report.cells import (
    ORDER_DEFINED,
    measured_table,
    order,
)
from prospect_mj.experiment.development.report.command import command
from prospect_mj.experiment.development.study.measured import Told
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.paper.measures.target import Verdict
from prospect_mj.experiment.paper.report.markdown import definitions, table

_MOST_SEQUENCES = 3

_SCENARIO = """\
1000 trials of recorded physics, the first 400 with the lid on the right: pretraining,
which makes the right hand dominant. Difficult trials are those after it with the lid
on the left. *Gone* counts from the end of the pretraining; *none*: the share was never
above 10 %; *never*: it is still above at the end. *Allowed* and *suppressed*: whether
an action that just had no effect may be run again in the same trial. All learners were
asked the same; controls are in the same tables.
"""

_STAGES = """\
What infants do is told by the paper in words only (sections 2 and 3.2, after McCarty,
Clifton and Collard 1999), so that only the order is compared, and trials are no ages.
Each pattern is looked for in windows of twenty trials: {rules}. Each cell has the
trials from the first such window to the last, and in brackets the share of the
resamples that have one. *In order*: the share in which the first windows of all three
come one after the other.
"""


def learners(results: Results) -> Iterator[str]:
    """The section, a piece at a time."""
    rows = results.learners
    yield "## Every learner under both rules"
    yield _SCENARIO.rstrip()
    yield "![Strategies of the four learners, and of a control](figures/strategies.png)"
    for rule in RULES:
        of_rule = [one for one in rows if one.row.rule == rule]
        yield f"### Failed actions {rule}"
        named = [((one.row.name,), one.measured) for one in of_rule]
        yield measured_table(("learner",), named)
    yield f"{definitions(MEASURES)}\n{ORDER_DEFINED}"
    yield "### Who develops as infants do"
    rows_of = by_row(rows)
    yield _criteria(rows_of, LIKE_INFANTS, developing(rows_of))
    yield "### Stages beside those of infants"
    rules = "; ".join(f"{age.months} months, {age.rule}" for age in AGES)
    yield _STAGES.format(rules=rules).rstrip()
    yield stages(rows)
    yield "### Single runs"
    yield (
        "Strategies that prevail one after the other in windows of ten difficult "
        "trials of a run, being more than a half of these, and the share of the runs "
        "with this sequence. Windows in which none prevails are passed over."
    )
    yield "![Single runs](figures/sequences.png)"
    yield _sequences(rows)
    yield _criteria(rows_of, OF_SINGLE_RUNS)
    yield command(results, "learners")


def stages(rows: list[Told]) -> str:
    """The table of stages of some rows, with what infants do in the first one."""
    head = ("", *(f"like {age.months} months" for age in AGES), "in order")
    infants = ("*infants*", *(age.infants for age in AGES), "yes")
    lines = [(_title(one), *_stage_cells(one.findings)) for one in rows]
    return table(head, [infants, *lines])


def _title(one: Told) -> str:
    return f"{one.row.name}, {one.row.rule}"


def _stage_cells(findings: Findings) -> list[str]:
    return [*map(_stage, findings.ages), order(findings.ages_in_order)]


def _stage(found: AgeFound) -> str:
    share = f"{100 * found.resamples:.0f} %"
    if isnan(found.first):
        return f"none ({share})"
    return f"{found.first:.0f} to {found.last:.0f} ({share})"


def _criteria(
    rows: Mapping[Subject, Findings],
    criteria: Sequence[Criterion],
    together: Mapping[Subject, Verdict] | None = None,
) -> str:
    """Who meets what, and what is asked for."""
    head = ("learner", "rule", *(one.name for one in criteria))
    lines = [
        (row.learner, row.rule, *(one.verdict for one in judged.values()))
        for row, judged in asked(rows, criteria).items()
    ]
    if together is not None:
        head = (*head, "all")
        lines = [
            (*line, f"**{together[row]}**")
            for row, line in zip(rows, lines, strict=True)
        ]
    asked_for = "\n".join(f"- *{one.name}*: {one.words}" for one in criteria)
    return f"{table(head, lines)}\n\n{asked_for}"


def _sequences(rows: list[Told]) -> str:
    lines = []
    for one in rows:
        for found in one.findings.sequences[:_MOST_SEQUENCES]:
            share = f"{found.share.words(0, 100)} %"
            lines.append((_title(one), words(found.sequence), share))
    return table(("learner", "sequence", "share of the runs"), lines)
