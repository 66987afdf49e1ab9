"""Pieces of Markdown."""

from collections.abc import Iterable, Sequence

from prospect_mj.experiment.paper.measures.measure import Measure


def definitions(measures: Iterable[Measure]) -> str:
    """A list of measures with their definitions."""
    return "\n".join(f"- *{each.title}*: {each.definition}" for each in measures)


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)
