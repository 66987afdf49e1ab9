"""Learners that are told more of a grasp than which hand holds the jar."""

from collections.abc import Mapping

from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.haptics.touch import Touch
from prospect_mj.experiment.development.study.rows import Row, population
from prospect_mj.experiment.development.study.settings import StudySettings

FEELING = ("linear", "discovery")
"""Learners that are told: the paper's, and that of the conjecture."""


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
