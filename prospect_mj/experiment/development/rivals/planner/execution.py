"""Carrying out plans on recorded outcomes, with a model that may be wrong.

After every action the planner takes in what it feels, which hand holds the jar, and
plans anew. What follows from an action that had no effect is the learners' rule for
failed actions (`agent.failed_actions`). Where they are "suppressed", no further plan of
the trial has the action; where no plan remains, the jar's ends must be the other way
round than was believed.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.agent.failed_actions import FailedActionRule, FailedActions
from prospect_mj.agent.haptics import LEFT, NONE, RIGHT
from prospect_mj.experiment.development.rivals.planner import facts as known
from prospect_mj.experiment.development.rivals.planner.facts import Facts, Operator
from prospect_mj.experiment.development.rivals.planner.geometry import Geometry
from prospect_mj.experiment.development.rivals.planner.regression import plan
from prospect_mj.recording.hands import hand_of, number_of
from prospect_mj.recording.recording import Recording
from prospect_mj.robot.names import SIDES, Side
from prospect_mj.task.presentation import Orientation


@dataclass
class Executed:
    """What a planner did in a trial."""

    actions: tuple[Action, ...] = ()
    inserted: bool = False

    def cost(self, max_actions: int) -> int:
        """Actions, all that a trial may have where it was not solved."""
        return len(self.actions) if self.inserted else max_actions


class Belief:
    """What a planner believes in a trial.

    Args:
        lid: the side on which it believes the lid to lie.
        rule: what follows from a failed action.
    """

    def __init__(self, lid: Orientation, rule: FailedActions) -> None:
        """Begin a trial."""
        self.facts: Facts = known.presented(lid)
        self._rule = FailedActionRule(rule)

    def next_step(
        self, geometry: Geometry, rng: np.random.Generator
    ) -> Operator | None:
        """The first operator of a new plan; None where there is none at all."""
        failed = self._failed()
        beliefs = [self.facts]
        if failed:
            beliefs.append(known.turned_round(self.facts))
        for facts in beliefs:
            made = plan(facts, geometry, rng, failed)
            if made.operators:
                self.facts = facts
                return made.operators[0]
        return None

    def felt(self, tried: Operator, holder: Side | None) -> None:
        """Take in which hand holds the jar after an action that did not insert it."""
        expected = tried.applied(self.facts)
        before = known.holder(self.facts)
        self._rule.note(number_of(before), tried.action, number_of(holder), False)
        if holder == known.holder(expected) and known.INSERTED not in expected:
            self.facts = expected
        elif holder != before:
            # It was lost, and is nowhere that the model knows.
            self.facts = frozenset(map(known.empty, SIDES))

    def _failed(self) -> frozenset[Action]:
        """What the rule leaves out, in whichever holding state a plan has it."""
        every = np.ones(len(Action), bool)
        remaining = [
            self._rule.remaining(holding, every) for holding in (NONE, LEFT, RIGHT)
        ]
        return frozenset(
            action for action in Action if not all(row[action] for row in remaining)
        )


def carry_out(
    recording: Recording,
    root: int,
    belief: Belief,
    geometry: Geometry,
    rng: np.random.Generator,
    max_actions: int = 10,
) -> Executed:
    """Plan and act until the jar is inserted or the trial is over.

    Args:
        recording: the outcomes.
        root: node where the trial begins.
        belief: what the planner believes of the jar.
        geometry: what it believes of sizes.
        rng: decides between equal plans.
        max_actions: the trial is cut off after so many.
    """
    done, node, nodes = Executed(), root, recording.nodes
    while len(done.actions) < max_actions and not done.inserted:
        operator = belief.next_step(geometry, rng)
        if operator is None:
            break
        led_to = int(nodes.child[node, operator.action])
        node = int(nodes.situation[led_to])
        done.actions += (operator.action,)
        done.inserted = bool(nodes.inserted[led_to])
        if not done.inserted:
            belief.felt(operator, hand_of(int(nodes.holding[node])))
    return done


def costs(executed: Iterable[Executed], max_actions: int) -> NDArray[np.int64]:
    """Actions of each trial (n,)."""
    return np.array([done.cost(max_actions) for done in executed])
