"""Learners that are told more of a grasp than which hand holds the jar."""

from collections.abc import Iterable, Mapping

from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.haptics.touch import CATEGORY, Touch
from prospect_mj.experiment.development.study.rows import Row, population
from prospect_mj.experiment.development.study.settings import StudySettings

FEELING = ("linear", "discovery")
"""Learners that are told: the paper's, and that of the conjecture."""
COUNTING = "discovery"
"""Is told categories of other numbers of models as well."""


def rows(
    study: StudySettings, categories: Mapping[str, Mapping[Touch, int]]
) -> list[Row]:
    """Both learners told each of the three, failed actions being suppressed.

    Args:
        study: its size.
        categories: by world, how many kinds of grasp each of the three has.
    """
    return [
        Row(
            "haptics",
            name,
            population(study, DEFAULTS[name], categories=number),
            world=world,
            touch=touch,
        )
        for world, numbers in categories.items()
        for name in FEELING
        for touch, number in numbers.items()
    ]


def of_numbers(study: StudySettings, numbers: Mapping[str, Iterable[int]]) -> list[Row]:
    """One learner told the category, for some numbers of models.

    Args:
        study: its size.
        numbers: of models, by world.
    """
    return [
        Row(
            "haptics",
            COUNTING,
            population(study, DEFAULTS[COUNTING], categories=n_models),
            world=world,
            touch=CATEGORY,
        )
        for world, some in numbers.items()
        for n_models in some
    ]
