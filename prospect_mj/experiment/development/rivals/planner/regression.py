"""Backward chaining: from "the jar is inserted" to what holds now.

Breadth first, so that the plan is a shortest one. Regression of goals through operators
is Waldinger's ("Achieving several goals simultaneously", Machine Intelligence 8, 1977).
"""

from collections import deque
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.experiment.development.rivals.planner.facts import (
    GOAL,
    Facts,
    Operator,
    consistent,
)
from prospect_mj.experiment.development.rivals.planner.geometry import Geometry
from prospect_mj.experiment.development.rivals.planner.operators import (
    Conditional,
    operators,
)


class Plan(NamedTuple):
    """What the planner would do, and what it took to find out."""

    operators: tuple[Operator, ...] | None
    """None: there is no plan."""
    regressions: int
    """Operators that a goal was taken back through."""
    queries: int
    """Questions to geometry."""

    @property
    def actions(self) -> tuple[Action, ...]:
        """Empty where there is no plan."""
        return tuple(operator.action for operator in self.operators or ())


def plan(
    facts: Facts,
    geometry: Geometry,
    rng: np.random.Generator,
    without: frozenset[Action] = frozenset(),
) -> Plan:
    """Find a shortest plan.

    Args:
        facts: what is believed to hold now.
        geometry: answers the questions.
        rng: decides between plans of equal length.
        without: actions that the plan may not have.
    """
    usable = [one for one in operators() if one.operator.action not in without]
    ordered = [usable[number] for number in rng.permutation(len(usable))]
    asked = geometry.queries
    found, regressions = _chained(facts, ordered, geometry)
    return Plan(found, regressions, geometry.queries - asked)


def _chained(
    facts: Facts, usable: Sequence[Conditional], geometry: Geometry
) -> tuple[tuple[Operator, ...] | None, int]:
    """The plan, None if there is none, and how many regressions it took."""
    waiting: deque[tuple[Facts, tuple[Operator, ...]]] = deque([(GOAL, ())])
    seen, regressions = {GOAL}, 0
    while waiting:
        goal, rest = waiting.popleft()
        for operator, possible in usable:
            before = operator.regressed(goal)
            if before is None or before in seen or not consistent(before):
                continue
            if possible(geometry):
                regressions += 1
                if before <= facts:
                    return (operator, *rest), regressions
                seen.add(before)
                waiting.append((before, (operator, *rest)))
    return None, regressions
