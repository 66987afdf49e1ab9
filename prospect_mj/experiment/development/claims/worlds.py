"""What is claimed of worlds that look unlike each other."""

from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType

from prospect_mj.experiment.development.claims.claim import (
    CONJECTURED,
    STAGED,
    Claim,
    asked_alike,
)
from prospect_mj.experiment.development.claims.criteria import (
    LATE_GONE_FIRST,
    LIKE_INFANTS,
    Figures,
    Judged,
    all_of,
    together,
)

ORDER_EVERYWHERE, DEVELOPS_EVERYWHERE = (
    "order in every world",
    "as infants in every world",
)

Worlds = Mapping[str, Figures]
"""What a learner comes to, by the name of the world."""

_ASKED: Mapping[str, tuple[str, Callable[[Figures], Judged]]] = MappingProxyType(
    {
        ORDER_EVERYWHERE: (
            "In every world of pictures that was tried, late corrections are gone "
            "before early ones.",
            LATE_GONE_FIRST.judge,
        ),
        DEVELOPS_EVERYWHERE: (
            "In every world of pictures that was tried, the learner develops as "
            "infants do, by all criteria.",
            partial(together, LIKE_INFANTS),
        ),
    }
)
"""Each with the words of the claim."""


def world_claims(learners: Mapping[str, Worlds]) -> list[Claim]:
    """All of them.

    Args:
        learners: by name, failed actions being suppressed.
    """
    return [
        _claim(name, learner, learners)
        for name in _ASKED
        for learner in STAGED
        if learner in learners
    ]


def _claim(name: str, learner: str, learners: Mapping[str, Worlds]) -> Claim:
    words, judge = _ASKED[name]
    judged = {
        other: {world: judge(figures) for world, figures in worlds.items()}
        for other, worlds in learners.items()
    }
    verdicts = {
        other: all_of([one.verdict for one in found.values()])
        for other, found in judged.items()
    }
    told = ". ".join(
        f"*{world}*: {one.words}" for world, one in judged[learner].items()
    )
    if learner == CONJECTURED.learner:
        told += asked_alike(verdicts)
    return Claim(words, verdicts[learner], told, learner, name)
