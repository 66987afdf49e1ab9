"""A test double of PickPlace-v0: every action that can succeed does, at once.

The jar may be taken by either hand when no hand holds it, passed on by the hand that
holds it, and inserted by the hand on the lid's side; everything else changes nothing.
As a script it is the training command line over this double.
"""

import sys
import time
from functools import partial

import numpy as np

from prospect_mj.agent import StateFeatureGenerator
from prospect_mj.cli import train
from prospect_mj.errors import RenderingUnavailable
from prospect_mj.supervisor.predicates import PRESENTED, carrying
from prospect_mj.supervisor.supervisor import Supervisor

# (needed state, next state) of the grasps and swaps, in the paper's order.
MOVES = {
    0: ("none", "left"),
    1: ("none", "right"),
    2: ("left", "right"),
    3: ("right", "left"),
}
INSERTIONS = {4: "left", 5: "right"}


def counts_per_orientation(energy=2.4, difference=0.95):
    """Two histograms (100,) with |v|^2 = energy and |v_L - v_R|^2 = difference."""
    cosine = 1 - difference / (2 * energy)
    common = np.zeros(100)
    common[:60] = 1.0
    histograms = {}
    for first_bin, orientation in ((60, "left"), (80, "right")):
        own = common.copy()
        own[first_bin : first_bin + 20] = np.sqrt(3 * (1 / cosine - 1))
        histograms[orientation] = own * np.sqrt(energy) / np.linalg.norm(own)
    return histograms


class IdealEnv:
    def __init__(self, config, noise=0.0, seconds_per_action=0.0):
        self.generator = StateFeatureGenerator(config.features, config.categories)
        self.max_actions = config.max_actions
        self.supervisor = Supervisor(config.supervisor, config.shaping)
        self.noise = noise
        self.seconds_per_action = seconds_per_action
        self.counts = counts_per_orientation()
        self.closed = False

    def reset(self, *, seed, options):
        rng = np.random.default_rng(seed)
        self.orientation, self.trial = options["orientation"], options.get("trial", 0)
        jitter = 1 + self.noise * rng.standard_normal(100)
        self.histogram = self.counts[self.orientation] * np.abs(jitter)
        self.holding, self.n_actions = "none", 0
        return self._features(), self._info(True, "seen", 0.1)

    def step(self, action):
        time.sleep(self.seconds_per_action)
        self.n_actions += 1
        inserted = INSERTIONS.get(action) == self.holding == self.orientation
        executed = inserted
        if action in MOVES and self.holding == MOVES[action][0]:
            executed, self.holding = True, MOVES[action][1]
        truncated = not inserted and self.n_actions == self.max_actions
        info = self._info(executed, "done" if executed else "refused", 1.5, inserted)
        return self._features(), -1.0, inserted, truncated, info

    def close(self):
        self.closed = True

    def _features(self):
        return self.generator.generate(self.histogram, self.holding)

    def _info(self, executed, result, sim_seconds, inserted=False):
        held = self.holding != "none"
        predicates = carrying(self.holding) if held else PRESENTED
        return {
            "action_mask": self.supervisor.choice_set(predicates, self.trial),
            "orientation": self.orientation,
            "holding": self.holding,
            "executed": executed,
            "result": result,
            "sim_seconds": sim_seconds,
            "inserted": inserted,
        }


def refuse(config):
    raise RenderingUnavailable("no OpenGL library; install libegl1")


if __name__ == "__main__":
    seconds = float(sys.argv[1])
    make_env = partial(IdealEnv, noise=0.05, seconds_per_action=seconds)
    sys.exit(train.main(sys.argv[2:], make_env=make_env))
