"""Learners in worlds that look unlike each other, and in one that changes."""

from collections.abc import Sequence
from dataclasses import replace

from prospect_mj.agent.failed_actions import RULES
from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.study.rows import Row, population
from prospect_mj.experiment.development.study.settings import DOMINANT, StudySettings

SEEING = ("discovery", "linear", "replay")
"""Learners that know a trial by its picture only."""
TRIALS_AFTER = 1000
"""Trials after the change: as many as before it."""
CHANGING = replace(DOMINANT, then_trials=TRIALS_AFTER)


def worlds(study: StudySettings, names: Sequence[str]) -> list[Row]:
    """Every learner in every world, failed actions being suppressed."""
    return [
        Row("worlds", name, population(study, DEFAULTS[name]), world=world)
        for world in names
        for name in SEEING
    ]


def changes(study: StudySettings, names: Sequence[str]) -> list[Row]:
    """Every learner under both rules, whose world changes after learning."""
    return [
        Row("change", name, population(study, learner, rule), CHANGING, then=world)
        for rule in RULES
        for world in names
        for name, learner in DEFAULTS.items()
    ]
