"""A row of the study: a population, and what is to be said of it."""

from dataclasses import dataclass
from typing import Literal

from prospect_mj.agent import AnyLearnerSettings
from prospect_mj.agent.failed_actions import FailedActions
from prospect_mj.agent.learners import with_categories
from prospect_mj.experiment.development.haptics.touch import BITS, Touch
from prospect_mj.experiment.development.study.settings import (
    DOMINANT,
    Part,
    StudySettings,
)
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.recording.worlds import STANDARD

Size = Literal["runs", "fewer_runs"]


@dataclass(frozen=True)
class Row:
    """One population of the study."""

    part: Part
    """That it is a row of."""
    name: str
    """Of the learner, or what is unlike the usual."""
    settings: PopulationSettings
    scenario: Scenario = DOMINANT
    world: str = STANDARD
    """In which learning begins."""
    then: str | None = None
    """The world that the scenario's last trials are in, if it has such."""
    touch: Touch = BITS
    """What the learner is told of a grasp."""

    @property
    def rule(self) -> FailedActions:
        """That for failed actions."""
        return self.settings.failed_actions

    @property
    def title(self) -> str:
        """Its name among all rows of the study."""
        where = "" if self.world == STANDARD else f", {self.world}"
        change = "" if self.then is None else f", then {self.then}"
        kinds = f", told the {self.touch}, one of {self.settings.categories}"
        touch = "" if self.touch == BITS else kinds
        return f"{self.name}, {self.rule}{where}{change}{touch}"


def population(
    study: StudySettings,
    learner: AnyLearnerSettings,
    rule: FailedActions = "suppressed",
    size: Size = "fewer_runs",
    categories: int = 0,
) -> PopulationSettings:
    """The settings of a row's population: seeds are the same in all rows.

    Args:
        study: its size.
        learner: of all runs.
        rule: for failed actions.
        size: which of the study's numbers of runs.
        categories: of grasps that the learner is told.
    """
    return PopulationSettings(
        runs=getattr(study, size),
        seed=study.seed,
        learner=with_categories(learner, categories),
        failed_actions=rule,
        categories=categories,
    )
