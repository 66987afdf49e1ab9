"""Learners on the recorded task with one thing of the abstract task that came before.

What is changed are the pictures, and what the abstract task's description leaves open
("Development feasibility"): the reading of the linear features, and whether what is
replayed knows the rule for failed actions. A change is made only of rows that know of
it: of the four learners under both rules, and of others that have abstract numbers.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import NamedTuple

from prospect_mj.agent import AnyLearnerSettings, ReplaySettings, TableSettings
from prospect_mj.agent.features import FeatureSettings
from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.study import causal, learners
from prospect_mj.experiment.development.study.abstract_told import TOLD
from prospect_mj.experiment.development.study.made_up import MadeUp
from prospect_mj.experiment.development.study.rows import Row
from prospect_mj.experiment.development.study.settings import Part, StudySettings
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.recording.recording import Recording

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

    pictures: bool = False
    """Made-up ones."""
    reading: bool = False
    """One-hot in place of the usual one."""
    forgets: bool = False
    """The targets of what is replayed count all actions."""

    def of(self, row: Row) -> "Change":
        """What is left of it for a row."""
        learner = row.settings.learner
        of_four = row.part == "learners" and row.name in DEFAULTS
        usual = of_four or row.part == "causal"
        return Change(
            self.pictures and usual and learner.name in PICTURES,
            self.reading and usual and learner.name in READERS,
            self.forgets and row.rule == "suppressed" and _replays(learner),
        )


NOTHING = Change()
BOTH = "both"
CHANGES: Mapping[str, Change] = MappingProxyType(
    {
        "made-up pictures": Change(pictures=True),
        "the other reading": Change(reading=True),
        BOTH: Change(pictures=True, reading=True),
        "replays that forget": Change(forgets=True),
    }
)


def rows(study: StudySettings, part: Part) -> list[Row]:
    """Those with a change, of one part.

    Args:
        study: its size.
        part: learners or causal; no other part has any.
    """
    recorded = {"learners": learners.rows, "causal": causal.rows}.get(part)
    if recorded is None:
        return []
    return [
        changed(row, change, study)
        for row in recorded(study)
        if row.name in DEFAULTS or (part, row.name, row.rule) in TOLD
        for change in _changes(row)
    ]


def changed(row: Row, change: Change, study: StudySettings) -> Row:
    """A row with a change, of as many runs as rows with one thing changed have.

    Args:
        row: as recorded.
        change: that it knows of.
        study: its size.
    """
    name, settings = row.name, replace(row.settings, runs=study.fewer_runs)
    if change.reading:
        name = f"{name}, {_OTHER.reading}"
        settings = replace(settings, features=_OTHER)
    if change.forgets:
        name = f"{name}, forgetting"
        learner = replace(settings.learner, replays_forget=True)
        settings = replace(settings, learner=learner)
    world = MADE_UP if change.pictures else row.world
    return replace(row, name=name, settings=settings, world=world)


def worlds(recording: Recording, study: StudySettings) -> dict[str, RecordedWorld]:
    """The recorded outcomes with made-up pictures, by the name of the learner."""
    return {
        name: RecordedWorld(look.presented(recording, study.rng(*_DRAWS)))
        for name, look in PICTURES.items()
    }


def _replays(learner: AnyLearnerSettings) -> bool:
    return isinstance(learner, ReplaySettings | TableSettings) and learner.replays > 0


def _changes(row: Row) -> Iterator[Change]:
    """Those that a row knows of, each once."""
    known = dict.fromkeys(change.of(row) for change in CHANGES.values())
    return (change for change in known if change != NOTHING)
