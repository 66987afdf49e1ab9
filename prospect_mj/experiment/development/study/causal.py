"""What makes the order: the discovery learner with one thing changed, or several.

All of them suppress failed actions. In the crossed rows with forced splits the true
orientation splits the contexts, insertions and all others at a trial each; in those
with labels the learner finds its features itself.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import product
from types import MappingProxyType

from prospect_mj.agent import DiscoverySettings
from prospect_mj.experiment.development.study.rows import Row, population
from prospect_mj.experiment.development.study.settings import DOMINANT, StudySettings

BASE, SHARED = "as it is", "first feature shared"
SOON, LATER = 50, 150
"""Trials after the pretraining at which contexts are split by force."""
ORDERS: Mapping[str, tuple[int, int]] = MappingProxyType(
    {
        "insertion first": (SOON, LATER),
        "both at once": (SOON, SOON),
        "grasp first": (LATER, SOON),
    }
)
"""When insertions, and when all other contexts are split [trials]."""
VALUES = ("examples", "stored", "inherit")
RATES = (0.002, 0.005, 0.02, 0.1)
"""Least rates of both crossed tables."""
LABELS, CACHES = ("td", "return"), ("surprising", "all")

_ONE_BY_ONE: Mapping[str, DiscoverySettings] = MappingProxyType(
    {
        BASE: DiscoverySettings(),
        "values inherited": DiscoverySettings(revalue="inherit"),
        "values from stored targets": DiscoverySettings(revalue="stored"),
        "TD labels, all cached": DiscoverySettings(cache="all"),
        "return labels": DiscoverySettings(labels="return"),
        "return labels, all cached": DiscoverySettings(labels="return", cache="all"),
        SHARED: DiscoverySettings(share_first=True),
        f"{SHARED}, values inherited": DiscoverySettings(
            share_first=True, revalue="inherit"
        ),
        "no feature re-used": DiscoverySettings(reuse=False),
        "no search after the first": DiscoverySettings(search_after_first=False),
        "one feature per context": DiscoverySettings(features_per_context=1),
        "expert phase": DiscoverySettings(expert_phase=True),
        "guard .05": DiscoverySettings(guard_probability=0.05),
        "guard 1e-7": DiscoverySettings(guard_probability=1e-7),
        "least rate .002": DiscoverySettings(least_rate=0.002),
        "least rate .01": DiscoverySettings(least_rate=0.01),
        "least rate .02": DiscoverySettings(least_rate=0.02),
        "least rate .05": DiscoverySettings(least_rate=0.05),
        "least rate .1": DiscoverySettings(least_rate=0.1),
        "surprise .25": DiscoverySettings(surprise=0.25),
        "surprise .75": DiscoverySettings(surprise=0.75),
        "discount .9": DiscoverySettings(discount=0.9),
        "epsilon .1": DiscoverySettings(epsilon=0.1),
    }
)
PRETRAININGS = (0, 100, 800)
"""Trials [1], beside those of the usual scenario."""


def rows(study: StudySettings) -> list[Row]:
    """All of them: one thing changed, then the two crossed tables."""
    return [
        *single(study),
        *(_row(study, name, learner) for name, learner in _forced()),
        *(_row(study, name, learner) for name, learner in _labelled()),
    ]


def single(study: StudySettings) -> Iterator[Row]:
    """The rows in which one thing is unlike the usual, or two that belong together."""
    for name, learner in _ONE_BY_ONE.items():
        yield _row(study, name, learner)
    after = DOMINANT.trials - DOMINANT.pretrain
    for trials in PRETRAININGS:
        row = _row(study, f"pretraining {trials}", DiscoverySettings())
        scenario = replace(DOMINANT, trials=trials + after, pretrain=trials)
        yield replace(row, scenario=scenario)


def forced_name(order: str, revalue: str, rate: float) -> str:
    """Name of a row with forced splits."""
    return f"{order}, {revalue}, {rate:g}"


def labelled_name(labels: str, cache: str, revalue: str, rate: float) -> str:
    """Name of a row of the table with labels."""
    return f"{labels}, {cache} cached, {revalue}, {rate:g}"


def _row(study: StudySettings, name: str, learner: DiscoverySettings) -> Row:
    return Row("causal", name, population(study, learner))


def _forced() -> Iterator[tuple[str, DiscoverySettings]]:
    for order, revalue, rate in product(ORDERS, VALUES, RATES):
        insertions, others = (DOMINANT.pretrain + trial for trial in ORDERS[order])
        splits = (("insert", insertions), ("others", others))
        yield (
            forced_name(order, revalue, rate),
            DiscoverySettings(least_rate=rate, revalue=revalue, forced_splits=splits),
        )


def _labelled() -> Iterator[tuple[str, DiscoverySettings]]:
    for labels, cache, revalue, rate in product(LABELS, CACHES, VALUES, RATES):
        yield (
            labelled_name(labels, cache, revalue, rate),
            DiscoverySettings(
                least_rate=rate, revalue=revalue, labels=labels, cache=cache
            ),
        )
