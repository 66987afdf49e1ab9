"""A made-up task for the discovery learner: bright pictures are good, dark ones bad."""

import numpy as np

from prospect_mj.agent import Observation, Transition

BRIGHT, DARK = 1, 0
OUTCOME = {BRIGHT: -1.0, DARK: -3.0}
"""What an action brings on a picture; it ends the trial."""


class NoDraws:
    """Stands for a generator that nothing is to be drawn from."""

    def integers(self, *_):
        raise AssertionError("something was drawn")


class Drawn:
    """Stands for a generator whose numbers are known."""

    def __init__(self, *numbers):
        self.numbers = list(numbers)

    def integers(self, *_):
        return self.numbers.pop(0)


def visual(kind):
    """Grey levels in the upper half of the histogram, or in the lower one."""
    bins = np.zeros(100)
    bins[50 * kind : 50 * kind + 50] = 0.2
    return bins


def seen(kind, haptic=0):
    """A state; the orientation is told to be that of the picture."""
    return Observation(np.zeros(0), visual(kind), haptic, kind)


def tried(kind, action=0, haptic=0):
    """An action that ends its trial."""
    state = seen(kind, haptic)
    outcome = OUTCOME[kind]
    return Transition(state, action, outcome, state, True, False, np.ones(6, bool))


def alternate(learner, n, rng, action=0):
    """Dark and bright pictures in turn, dark first, until n trials have ended."""
    for number in range(n):
        learner.update(tried((DARK, BRIGHT)[number % 2], action), rng)
