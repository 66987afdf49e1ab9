"""The learners that are compared, under both rules for failed actions."""

from collections.abc import Mapping
from types import MappingProxyType

from prospect_mj.agent import (
    AnyLearnerSettings,
    LinearSettings,
    TableSettings,
)
from prospect_mj.agent.failed_actions import RULES
from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.study.rows import Row, population
from prospect_mj.experiment.development.study.settings import StudySettings

_SLOW = 0.02
"""Step size of the tables that have a habit [1], as in the feasibility study."""

CONTROLS: Mapping[str, AnyLearnerSettings] = MappingProxyType(
    {
        "linear, step .02": LinearSettings(step_size=0.02),
        "linear, step .05": LinearSettings(step_size=0.05),
        "linear, step .1": LinearSettings(step_size=0.1),
        "table, replays": TableSettings(replays=10),
        "table, copied habit": TableSettings(_SLOW, copied_habit=True),
        "table, copied habit, known correction": TableSettings(
            _SLOW, copied_habit=True, known_correction=True
        ),
        "table, copied habit, replays": TableSettings(
            _SLOW, replays=10, copied_habit=True
        ),
        "table, copied habit, known correction, replays": TableSettings(
            _SLOW, replays=10, copied_habit=True, known_correction=True
        ),
    }
)
"""Learners that could show the same for other reasons, by name."""

FEATURELESS = "table, copied habit, known correction, replays"
"""That control which needs no features at all to develop as the others may."""
SHOWN = (*DEFAULTS, FEATURELESS)
"""Those that are drawn."""


def rows(study: StudySettings) -> list[Row]:
    """Every learner under both rules."""
    return [
        Row("learners", name, population(study, learner, rule, "runs"))
        for rule in RULES
        for name, learner in {**DEFAULTS, **CONTROLS}.items()
    ]
