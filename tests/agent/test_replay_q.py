from dataclasses import replace

import numpy as np
import pytest
from told import random_steps, seen, step

from prospect_mj.agent import (
    LinearQ,
    LinearSettings,
    ReplayQ,
    ReplaySettings,
    TableSettings,
)
from prospect_mj.errors import InvalidValue

SMALL = ReplaySettings(
    step_size=0.5, discount=0.5, replays=1, buffer=2, n_actions=2, n_features=2
)
A, B = seen([1, 0]), seen([0, 1])


class Places:
    """Stands for the learning generator: the places that are replayed, in order."""

    def __init__(self, *places):
        self.places, self.asked = list(places), []

    def integers(self, n):
        self.asked.append(n)
        return self.places.pop(0)


def test_replay_by_hand():
    learner, rng = ReplayQ(SMALL), Places(0, 0)
    # Q(A, 0): -1 of 0; .5 of it, and .5 of the -.5 that are left.
    error = learner.update(step(A, 0, B, True, n=2), rng)
    assert error == -1
    np.testing.assert_array_equal(learner.weights, [[-0.75, 0], [0, 0]])
    # Q(B, 1): target -1 + .5 max(-.75, 0) = -1, so -.5; then A again: -.75 to -.875.
    assert learner.update(step(B, 1, A, n=2), rng) == -1
    np.testing.assert_array_equal(learner.weights, [[-0.875, 0], [0, -0.5]])
    assert rng.asked == [1, 2]
    assert learner.n_updates == 2


def test_replayed_targets_are_those_of_the_present_weights_and_choices():
    learner, rng = ReplayQ(SMALL), Places(0)
    learner.weights[:] = [[0, 0], [0, -8]]
    # Only action 1 may follow in B: -1 + .5 x -8 = -5.
    only_second = step(A, 0, B, allowed=[False, True])
    assert learner.update(only_second, rng) == -5
    assert learner.weights[0, 0] == -2.5 - 1.25
    learner.weights[1, 1] = 0.0
    rng.places.append(0)
    # B, 0 ends; what is replayed has the target -1 + .5 x 0 by now.
    learner.update(step(B, 0, B, True, n=2), rng)
    assert learner.weights[0, 0] == -3.75 + 0.5 * (-1 + 3.75)


def test_replays_that_forget_count_all_actions():
    learner = ReplayQ(replace(SMALL, replays_forget=True))
    learner.weights[:] = [[0, 0], [0, -8]]
    # -1 + .5 x -8 by the action that may follow; -1 + .5 x 0 by any, when replayed.
    only_second = step(A, 0, B, allowed=[False, True])
    assert learner.update(only_second, Places(0)) == -5
    assert learner.weights[0, 0] == -2.5 + 0.5 * (-1 + 2.5)


def test_newest_takes_the_place_of_the_oldest():
    settings = ReplaySettings(
        step_size=1.0, replays=1, buffer=2, n_actions=1, n_features=3
    )
    learner = ReplayQ(settings)
    rng, states = Places(0, 1, 0), [seen(row) for row in np.eye(3)]
    for number, state in enumerate(states):
        if number == 2:
            learner.weights[:] = 0.0
        learner.update(step(state, 0, state, True, n=1), rng)
    # The third went to place 0: the first is forgotten, and was not learned again.
    np.testing.assert_array_equal(learner.weights, [[0, 0, -1]])
    assert rng.asked == [1, 2, 2]


def test_without_replays_it_is_the_linear_learner():
    linear = LinearQ(LinearSettings(step_size=0.02), np.random.default_rng(3))
    replay = ReplayQ(ReplaySettings(replays=0), np.random.default_rng(3))
    for given in random_steps(60, seed=4):
        errors = [one.update(given, Places()) for one in (linear, replay)]
        assert errors[0] == errors[1]
    np.testing.assert_array_equal(linear.weights, replay.weights)


def test_replays_come_near_to_what_is_experienced_sooner():
    """The error of a single transition shrinks by (1 - alpha |phi|^2)^11."""
    given = next(random_steps(1, seed=5))._replace(terminated=True)
    learner, rng = ReplayQ(ReplaySettings(buffer=1)), np.random.default_rng(0)
    energy = float(np.sum(given.observation.features**2))
    errors = [learner.update(given, rng) for _ in range(2)]
    assert errors[1] == pytest.approx(errors[0] * (1 - 0.02 * energy) ** 11)


def test_learning_draws_leave_choices_alone():
    learner, rng = ReplayQ(), np.random.default_rng(1)
    state = rng.bit_generator.state
    for given in random_steps(5, seed=6):
        learner.update(given, np.random.default_rng(2))
    assert rng.bit_generator.state == state


@pytest.mark.parametrize(
    ("setting", "bad"),
    [("replays", -1), ("replays", 1.5), ("buffer", 0), ("step_size", 0.0)],
)
def test_bad_replays_are_refused(setting, bad):
    with pytest.raises(InvalidValue, match=setting):
        ReplaySettings(**{setting: bad})


@pytest.mark.parametrize("settings", [ReplaySettings, TableSettings])
def test_without_replays_nothing_is_forgotten_in_them(settings):
    with pytest.raises(InvalidValue, match="replays_forget"):
        settings(replays=0, replays_forget=True)
