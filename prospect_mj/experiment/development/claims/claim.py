"""A claim, and of whom it is made."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

from prospect_mj.experiment.paper.measures.target import Verdict


class Subject(NamedTuple):
    """A learner under a rule for failed actions."""

    learner: str
    """Its name, or that of a control."""
    rule: str
    """`allowed` or `suppressed`."""

    @property
    def words(self) -> str:
        """For tables and sentences."""
        return f"{self.learner}, {self.rule}"


@dataclass(frozen=True)
class Claim:
    """A sentence, and whether it holds."""

    words: str
    verdict: Verdict
    evidence: str
    """What was measured."""
    of: str = ""
    """What it is claimed of, where the same is asked of several."""
    name: str = ""
    """For what rests on it."""


AS_PAPER = Subject("linear", "allowed")
CONJECTURED = Subject("discovery", "suppressed")
STAGED = CONJECTURED.learner, "replay"
"""Learners of which stages are claimed, whatever world; others are asked the same."""


def asked_alike(verdicts: Mapping[str, Verdict]) -> str:
    """What the same comes to with learners of which it is not claimed, for evidence."""
    others = [
        f"*{learner}*, {verdict}"
        for learner, verdict in verdicts.items()
        if learner not in STAGED
    ]
    return f". Asked alike: {'; '.join(others)}" if others else ""
