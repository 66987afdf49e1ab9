"""Populations whose learners are unlike each other, as children are."""

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.study.rows import Row, population
from prospect_mj.experiment.development.study.settings import StudySettings
from prospect_mj.experiment.populations.scenario import PopulationSettings
from prospect_mj.experiment.populations.spread import Spread

SPREADS: Mapping[str, tuple[Spread, ...]] = MappingProxyType(
    {
        "discovery": (
            Spread("least_rate", 0.002, 0.02, logarithmic=True),
            Spread("surprise", 0.25, 0.75),
        ),
        "replay": (
            Spread("step_size", 0.005, 0.05, logarithmic=True),
            Spread("replays", 3, 15),
            Spread("buffer", 300, 2000),
        ),
    }
)
"""What every learner draws for itself, by the learner's name."""


def rows(study: StudySettings) -> list[Row]:
    """Spread populations, failed actions being suppressed."""
    return [
        Row("population", name, replace(_alike(study, name), spread=spread))
        for name, spread in SPREADS.items()
    ]


def _alike(study: StudySettings, name: str) -> PopulationSettings:
    return population(study, DEFAULTS[name], size="runs")
