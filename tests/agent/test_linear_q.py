import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import chisquare
from told import Draws, seen, step

from prospect_mj.agent import LinearQ, LinearSettings
from prospect_mj.errors import InvalidChoice, InvalidValue

SMALL = LinearSettings(
    step_size=0.1, epsilon=0.2, discount=0.9, n_actions=3, n_features=2
)


def small_learner(weights=((1.0, 2.0), (3.0, -1.0), (0.0, 0.5)), settings=SMALL):
    learner = LinearQ(settings)
    learner.weights[:] = weights
    return learner


def learn(learner, phi, action, next_phi, terminated=False, allowed=None, reward=-1.0):
    n = learner.settings.n_actions
    given = step(seen(phi), action, seen(next_phi), terminated, allowed, reward, n)
    return learner.update(given, np.random.default_rng(0))


def test_defaults_are_the_papers():
    settings = LinearSettings()
    assert (settings.step_size, settings.epsilon) == (0.004, 0.05)
    assert (settings.discount, settings.n_actions) == (0.99, 6)
    assert settings.n_features == 303
    assert not LinearQ().weights.any()


def test_initial_weights_are_drawn_with_the_deviation_asked_for():
    settings = LinearSettings(initial_sd=0.3, n_features=20_000)
    weights = LinearQ(settings, rng=np.random.default_rng(2)).weights
    assert abs(weights.mean()) < 5 * 0.3 / np.sqrt(weights.size)
    assert abs(weights.std() - 0.3) < 5 * 0.3 / np.sqrt(2 * weights.size)
    again = LinearQ(settings, rng=np.random.default_rng(2)).weights
    np.testing.assert_array_equal(again, weights)
    zero = LinearSettings(initial_sd=0.0)
    assert not LinearQ(zero, rng=np.random.default_rng(2)).weights.any()


def test_q_values_by_hand():
    np.testing.assert_array_equal(small_learner().q_values(seen([2, 1])), [4, 5, 0.5])


def test_update_by_hand():
    learner = small_learner()
    # Q(phi, 0) = 4; max Q(phi', .) = max(2, -1, .5) = 2
    # delta = -1 + .9 x 2 - 4 = -3.2; theta_0 += .1 x -3.2 x (2, 1)
    error = learn(learner, [2, 1], 0, [0, 1])
    assert error == pytest.approx(-3.2)
    np.testing.assert_allclose(learner.weights, [[0.36, 1.68], [3, -1], [0, 0.5]])
    assert learner.n_updates == 1


def test_terminal_update_by_hand():
    learner = small_learner()
    # delta = -1 - 5 = -6; theta_1 += .1 x -6 x (2, 1)
    error = learn(learner, [2, 1], 1, [1e9, 1e9], terminated=True)
    assert error == -6
    np.testing.assert_allclose(learner.weights, [[1, 2], [1.8, -1.6], [0, 0.5]])


def test_update_bootstraps_from_the_next_choice_set_only():
    learner = small_learner()
    # without action 0 the largest next value is 0.5
    error = learn(learner, [2, 1], 0, [0, 1], allowed=[0, 1, 1])
    assert error == pytest.approx(-1 + 0.9 * 0.5 - 4)


def test_terminal_update_needs_no_choice_set():
    learner = small_learner()
    assert learn(learner, [2, 1], 0, [0, 1], True, allowed=[0, 0, 0]) == -5


@pytest.mark.parametrize(
    ("draws", "allowed", "expected", "explored"),
    [
        ((0.2, 0.99), None, 1, False),  # not below epsilon: the best
        ((0.19, 0.0), None, 0, True),
        ((0.19, 0.34), None, 1, True),
        ((0.19, 0.999), None, 2, True),
        ((0.19, 0.5), [1, 0, 1], 2, True),  # number floor(.5 x 2) of (0, 2)
        ((0.5, 0.5), [1, 0, 1], 0, False),
    ],
)
def test_choice_follows_its_two_draws(draws, allowed, expected, explored):
    rng = Draws(*draws)
    choice = small_learner().select(seen([2, 1]), rng, allowed)
    assert (choice.action, choice.explored) == (expected, explored)
    np.testing.assert_array_equal(choice.q_values, [4, 5, 0.5])
    assert rng.numbers == []


@given(
    mask=st.lists(st.booleans(), min_size=6, max_size=6).filter(any),
    seed=st.integers(0, 2**32),
    epsilon=st.sampled_from([0.0, 0.5, 1.0]),
)
def test_select_never_picks_a_masked_action(mask, seed, epsilon):
    rng = np.random.default_rng(seed)
    learner = LinearQ(LinearSettings(epsilon=epsilon, n_features=3))
    learner.weights[:] = rng.integers(0, 2, learner.weights.shape)
    for _ in range(20):
        allowed = np.array(mask, dtype=np.int8)
        assert mask[learner.select(seen(rng.random(3)), rng, allowed).action]


def test_greedy_choice_is_the_best_allowed_one():
    rng = np.random.default_rng(3)
    learner = LinearQ(LinearSettings(epsilon=0.0, n_features=3))
    learner.weights[:] = rng.standard_normal(learner.weights.shape)
    for _ in range(50):
        features, mask = rng.standard_normal(3), rng.integers(0, 2, 6)
        mask[rng.integers(6)] = 1
        values = np.where(mask, learner.q_values(seen(features)), -np.inf)
        assert learner.select(seen(features), rng, mask).action == values.argmax()


def test_ties_are_broken_uniformly():
    learner = LinearQ(LinearSettings(epsilon=0.0))
    learner.weights[[0, 2, 5], 0] = 1.0
    rng, features = np.random.default_rng(11), np.eye(303)[0]
    chosen = [learner.select(seen(features), rng).action for _ in range(6000)]
    counts = np.bincount(chosen, minlength=6)
    assert not counts[[1, 3, 4]].any()
    assert chisquare(counts[[0, 2, 5]]).pvalue > 0.01


def test_exploration_has_its_probability():
    learner = LinearQ(LinearSettings(epsilon=0.3))
    learner.weights[4, 0] = 1.0
    rng, features = np.random.default_rng(12), np.eye(303)[0]
    chosen = [learner.select(seen(features), rng) for _ in range(6000)]
    explored = np.mean([choice.explored for choice in chosen])
    assert explored == pytest.approx(0.3, abs=3 * np.sqrt(0.21 / 6000))
    counts = np.bincount([c.action for c in chosen if c.explored], minlength=6)
    assert chisquare(counts).pvalue > 0.01


def test_known_mdp_converges_to_its_action_values():
    # A corridor 0-1-2-goal, one feature per state: action 0 steps back (or stays at
    # the wall), action 1 forward, each costs 1. Q* follows from the steps left.
    discount = 0.9
    value = [-(1 - discount**steps) / (1 - discount) for steps in (3, 2, 1, 0)]
    optimal = np.array(
        [
            [-1 + discount * value[max(state - 1, 0)] for state in range(3)],
            [-1 + discount * value[state + 1] for state in range(3)],
        ]
    )
    settings = LinearSettings(0.5, 0.5, discount, n_actions=2, n_features=3)
    learner, rng, states = LinearQ(settings), np.random.default_rng(0), np.eye(4)[:, :3]
    for _ in range(300):
        state = 0
        while state < 3:
            action = learner.select(seen(states[state]), rng).action
            reached = state + 1 if action else max(state - 1, 0)
            learn(learner, states[state], action, states[reached], reached == 3)
            state = reached
    np.testing.assert_allclose(learner.weights, optimal, atol=1e-6)


def test_updates_repeat_exactly_whatever_the_memory_layout():
    rng = np.random.default_rng(2)
    first, second = LinearQ(), LinearQ()
    for _ in range(50):
        phi, next_phi = rng.random((2, 303))
        spread = np.zeros(606)
        spread[1::2] = phi
        action = int(rng.integers(6))
        learn(first, phi, action, next_phi)
        learn(second, spread[1::2], action, next_phi)
    np.testing.assert_array_equal(first.weights, second.weights)


def use(learner, **changes):
    arguments = {
        "phi": [1, 1],
        "action": 0,
        "next_phi": [1, 1],
    }
    learn(learner, **{**arguments, **changes})


@pytest.mark.parametrize(
    ("changes", "named"),
    [
        ({"phi": [1, 1, 1]}, "(3,)"),
        ({"phi": [1, np.nan]}, "NaN"),
        ({"next_phi": [[1, 1]]}, "(1, 2)"),
        ({"action": 3}, "0 to 2"),
        ({"action": -1}, "0 to 2"),
        ({"action": 1.5}, "action is 1.5; expected an integer from 0 to 2"),
        ({"action": "left"}, "'left'"),
        ({"reward": np.nan}, "finite"),
        ({"allowed": [1, 1]}, "(2,)"),
        ({"allowed": [0, 0, 0]}, "one action allowed"),
    ],
)
def test_bad_transition_is_named_and_teaches_nothing(changes, named):
    learner = small_learner()
    with pytest.raises(InvalidValue) as refused:
        use(learner, **changes)
    assert named in str(refused.value)
    np.testing.assert_array_equal(learner.weights, small_learner().weights)
    assert learner.n_updates == 0


def test_divergence_is_reported():
    learner = LinearQ(LinearSettings(step_size=1.0, n_actions=1, n_features=1))

    def diverge():
        for _ in range(2000):
            learn(learner, [10.0], 0, [10.0], True)

    with (
        np.errstate(over="ignore", invalid="ignore"),
        pytest.raises(InvalidValue, match="below 2"),
    ):
        diverge()


@pytest.mark.parametrize(
    ("setting", "bad", "valid"),
    [
        ("step_size", 0.0, "a number in (0, 10]"),
        ("step_size", float("nan"), "a number in (0, 10]"),
        ("step_size", 11.0, "a number in (0, 10]"),
        ("step_size", "a", "a number in (0, 10]"),
        ("epsilon", -0.1, "a number in [0, 1]"),
        ("epsilon", 1.1, "a number in [0, 1]"),
        ("epsilon", True, "a number in [0, 1]"),
        ("discount", 1.01, "a number in [0, 1]"),
        ("discount", None, "a number in [0, 1]"),
        ("n_actions", 0, "an integer from 1"),
        ("n_actions", 2.5, "an integer from 1"),
        ("n_features", 0, "an integer from 1"),
    ],
)
def test_bad_settings_are_refused(setting, bad, valid):
    with pytest.raises(InvalidValue) as refused:
        LinearSettings(**{setting: bad})
    assert f"is {bad!r}; expected {valid}" in str(refused.value)


def test_action_may_be_a_numpy_integer():
    learner = small_learner()
    use(learner, action=np.int64(2))
    assert learner.n_updates == 1


def test_state_is_taken_over_and_not_shared():
    learner, other = small_learner(), LinearQ(SMALL)
    learn(learner, [2, 1], 0, [0, 1])
    other.restore(learner.state())
    np.testing.assert_array_equal(other.weights, learner.weights)
    assert other.n_updates == 1
    learn(other, [2, 1], 0, [0, 1])
    assert (other.weights != learner.weights).any()


@pytest.mark.parametrize(
    "changes",
    [
        {"weights": np.zeros((3, 3))},
        {"weights": np.full((3, 2), np.inf)},
        {"weights": np.zeros((3, 2), np.float32)},
        {"n_updates": np.array(-1)},
        {"n_updates": np.array([1])},
        {"values": np.zeros(3)},
    ],
)
def test_foreign_state_is_refused(changes):
    state = {**small_learner().state(), **changes}
    with pytest.raises((InvalidValue, InvalidChoice)):
        small_learner().restore(state)
