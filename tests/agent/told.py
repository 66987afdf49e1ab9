"""What learners are told in tests, by hand."""

import numpy as np

from prospect_mj.agent import Observation, Transition
from prospect_mj.agent.features import N_BINS, StateFeatureGenerator

HOLDINGS = "none", "left", "right"


class Draws:
    """Stands for a generator whose numbers are known."""

    def __init__(self, *numbers):
        self.numbers = list(numbers)

    def random(self):
        return self.numbers.pop(0)


def seen(features=(), haptic=0, orientation=0):
    """A state of which some learner reads only one of these."""
    phi = np.asarray(features, float)
    return Observation(phi, np.zeros(N_BINS), haptic, orientation)


def step(before, action, after, terminated=False, allowed=None, reward=-1.0, n=6):
    """A transition between two observations; None allows all of `n` actions."""
    mask = np.ones(n, bool) if allowed is None else np.asarray(allowed)
    return Transition(before, action, reward, after, terminated, False, mask)


def random_steps(n, seed):
    """Whole trials of a made-up task, with the real features, of n steps in all."""
    rng, generator = np.random.default_rng(seed), StateFeatureGenerator()
    ended = True
    for number in range(n):
        if ended:
            counts, side = rng.integers(0, 9, N_BINS), int(rng.integers(2))
        before, after = (
            Observation.of(generator.generate(counts, HOLDINGS[h]), side)
            for h in rng.integers(0, 3, 2)
        )
        allowed = rng.random(6) < 0.7
        allowed[rng.integers(6)] = True
        ended = bool(rng.random() < 0.2) or number == n - 1
        yield step(before, int(rng.integers(6)), after, ended, allowed)
