"""Which criteria a population does not meet, in words short enough for tables."""

from collections.abc import Mapping
from types import MappingProxyType

from prospect_mj.experiment.development.claims.criteria import LIKE_INFANTS, Figures
from prospect_mj.experiment.paper.measures.target import Verdict

SHORT: Mapping[str, str] = MappingProxyType(
    {
        "late corrections prevail": "late stage",
        "late gone first": "order",
        "corrections dominate": "dominance",
        "early corrections lead": "early lead",
        "optimal in the end": "end",
        "easy trials spared": "easy trials",
    }
)
"""What each of `LIKE_INFANTS` is about, by its name."""

EXPLAINED = ", ".join(f"*{short}*: {name}" for name, short in SHORT.items())
"""The short words, in those of the criteria."""


def unmet(figures: Figures) -> tuple[str, ...]:
    """What lacks for a population to develop as infants do.

    Args:
        figures: of the population.

    Returns:
        The short words, those that are undecided with a question mark; none if all
        criteria hold.
    """
    judged = {SHORT[one.name]: one.judge(figures).verdict for one in LIKE_INFANTS}
    return tuple(
        f"{short}?" if verdict is Verdict.OPEN else short
        for short, verdict in judged.items()
        if verdict is not Verdict.HOLDS
    )
