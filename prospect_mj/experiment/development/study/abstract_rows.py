"""Learners on the recorded task with one thing of the abstract task that came before.

What is changed are the pictures, and the reading of the linear features, which the
abstract task's description leaves open ("Development feasibility"). A change is made
only of learners that know of it.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import NamedTuple

from prospect_mj.agent.failed_actions import RULES, FailedActions
from prospect_mj.agent.features import FeatureSettings
from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.study.made_up import MadeUp
from prospect_mj.experiment.development.study.rows import Row, population
from prospect_mj.experiment.development.study.settings import StudySettings
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.worlds import STANDARD

MADE_UP = "made-up"
"""Name of the standard world with made-up pictures."""
_OTHER = FeatureSettings(reading="one_hot")
_DRAWS = 0, 0, 0
"""Key of the numbers that pictures are made of: longer than those of the rows."""

PICTURES: Mapping[str, MadeUp] = MappingProxyType(
    {
        "linear": MadeUp(cosine=0.8, noise=0.05),
        "replay": MadeUp(cosine=0.8, noise=0.05),
        "discovery": MadeUp(cosine=0.95, noise=0.3),
    }
)
"""Of the abstract task, by the name of the learner."""
READERS = ("linear", "replay")
"""Learners that know states by the linear features."""


class Change(NamedTuple):
    """What is as in the abstract task, or may have been so."""

    pictures: bool
    """Made-up ones."""
    reading: bool
    """One-hot in place of the usual one."""

    def known_to(self, learner: str) -> "Change":
        """What is left of it for a learner."""
        return Change(
            self.pictures and learner in PICTURES, self.reading and learner in READERS
        )


BOTH = "both"
NOTHING = Change(pictures=False, reading=False)
CHANGES: Mapping[str, Change] = MappingProxyType(
    {
        "made-up pictures": Change(pictures=True, reading=False),
        "the other reading": Change(pictures=False, reading=True),
        BOTH: Change(pictures=True, reading=True),
    }
)


def rows(study: StudySettings) -> list[Row]:
    """Every learner under both rules, with each change that it knows of."""
    return [
        _row(study, name, rule, change)
        for rule in RULES
        for name in DEFAULTS
        for change in _changes(name)
    ]


def key(name: str, rule: str, change: Change) -> tuple[str, str, str]:
    """Name, rule and world of the row of a learner with a change that it knows of.

    Without any change they are those of the recorded task's own row.
    """
    return _title(name, change), rule, _world(change)


def worlds(recording: Recording, study: StudySettings) -> dict[str, RecordedWorld]:
    """The recorded outcomes with made-up pictures, by the name of the learner."""
    return {
        name: RecordedWorld(look.presented(recording, study.rng(*_DRAWS)))
        for name, look in PICTURES.items()
    }


def _row(study: StudySettings, name: str, rule: FailedActions, change: Change) -> Row:
    settings = population(study, DEFAULTS[name], rule)
    if change.reading:
        settings = replace(settings, features=_OTHER)
    return Row("learners", _title(name, change), settings, world=_world(change))


def _title(name: str, change: Change) -> str:
    return f"{name}, {_OTHER.reading}" if change.reading else name


def _world(change: Change) -> str:
    return MADE_UP if change.pictures else STANDARD


def _changes(name: str) -> Iterator[Change]:
    """Those that a learner knows of, each once."""
    known = dict.fromkeys(change.known_to(name) for change in CHANGES.values())
    return (change for change in known if change != NOTHING)
