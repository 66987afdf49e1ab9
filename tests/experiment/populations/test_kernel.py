"""Compiled runs of trials: what they refuse, and what they are offered."""

import numpy as np
import pytest
from ideal_recording import clumsy, ideal, one_handed, recording, unseen

from prospect_mj.agent import (
    LinearQ,
    LinearSettings,
    ReplaySettings,
    TableSettings,
    new_learner,
)
from prospect_mj.errors import InvalidValue, RecordingError
from prospect_mj.experiment.populations.compiled_learner import (
    rule_of,
    run_frozen,
    run_trials,
)
from prospect_mj.experiment.populations.kernels.graph import Trials
from prospect_mj.experiment.populations.outcome_graph import (
    HANDS,
    ideal_graph,
    ideal_root,
)
from prospect_mj.experiment.populations.population import learn
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.recording.choices import phases
from prospect_mj.supervisor.supervisor import Supervisor

FAST = LinearSettings(step_size=0.02, epsilon=0.1, initial_sd=0.0)
LEFT, RIGHT = HANDS


@pytest.fixture(scope="module")
def odd():
    """A recording in which much goes wrong."""
    kinds = (ideal, clumsy, one_handed, unseen, ideal)
    return recording(left=kinds, right=kinds)


def learn_from(graph, presented, settings=FAST, **rule):
    """What a new learner does."""
    rng = np.random.default_rng(0)
    learner = new_learner(settings)
    kept = rule_of(settings, **rule)
    return run_trials(learner, graph, presented, kept, rng).outcomes


def trials(n_trials=4, **changes):
    arrays = {
        "root": np.array([ideal_root(LEFT), ideal_root(RIGHT)] * (n_trials // 2)),
        "image": np.arange(n_trials),
        "visual": np.full((n_trials, 100), 0.1),
        "orientation": np.arange(n_trials) % 2,
        "phase": np.zeros(n_trials),
        "draws": np.random.default_rng(0).random((n_trials, 10, 2)),
    }
    kinds = dict.fromkeys(("root", "image", "phase"), np.int32)
    kinds["orientation"] = np.int64
    arrays |= changes
    return Trials(**{k: v.astype(kinds.get(k, float)) for k, v in arrays.items()})


def test_an_outcome_that_was_not_recorded_is_an_error():
    graph = ideal_graph()
    graph.child[ideal_root(RIGHT), :] = -1
    with pytest.raises(RecordingError, match="trial 1 was not recorded"):
        learn_from(graph, trials())


@pytest.mark.parametrize("settings", [FAST, ReplaySettings(step_size=0.02)])
def test_a_learner_that_diverges_is_an_error(settings):
    graph, bright = ideal_graph(), np.full((400, 100), 1000.0)
    with pytest.raises(InvalidValue, match="temporal-difference error of trial"):
        learn_from(graph, trials(400, visual=bright), settings)


def test_a_table_can_diverge_too():
    settings = TableSettings(step_size=10.0, epsilon=1.0)
    with pytest.raises(InvalidValue, match="temporal-difference error of trial"):
        learn_from(ideal_graph(), trials(2000), settings)


def test_a_value_that_is_no_number_is_an_error():
    learner = LinearQ()
    learner.weights[3, 302] = np.nan
    with pytest.raises(InvalidValue, match="NaN"):
        run_frozen(learner, ideal_graph(), trials())


def test_nothing_to_choose_from_is_an_error():
    choices = np.ones((2, 3, 6), bool)
    choices[1, 2] = False
    graph = ideal_graph()._replace(choices=choices)
    words = r"choice set of state 2 in phase 1 is \[\]; expected an action at least"
    with pytest.raises(InvalidValue, match=words):
        run_frozen(LinearQ(), graph, trials())
    choices[1, 2, 5] = True
    run_frozen(LinearQ(), graph, trials())


def test_frozen_policy_is_greedy_and_learns_nothing():
    learner = LinearQ()
    weights = learner.weights
    weights[0, 302], weights[4, 300] = 1.0, 2.0  # Grasp left, insert left.
    before = weights.copy()
    done = run_frozen(learner, ideal_graph(), trials())
    np.testing.assert_array_equal(weights, before)
    assert done.n_actions.tolist() == [2, 10, 2, 10]
    assert done.solved.tolist() == [True, False, True, False]
    assert done.action[0].tolist() == [0, 4] + [-1] * 8
    assert done.action[1].tolist() == [0] + [4] * 9
    # Left of the ideal graph: the jar lies, in the left hand, in the right, inserted.
    assert done.node[0].tolist() == [1, 3] + [-1] * 8
    assert done.node[1].tolist() == [5] * 10


def test_a_failed_action_is_suppressed_in_its_holding_state_until_the_trial_ends():
    # In an ideal graph there is always an action left that has an effect.
    settings = LinearSettings(epsilon=1.0)
    done = learn_from(ideal_graph(), trials(400), settings, failed_actions="suppressed")
    for actions, nodes, root in zip(
        done.action, done.node, trials(400).root, strict=True
    ):
        before = [root, *nodes[:-1]]
        failed = set()
        for action, node, led_to in zip(actions, before, nodes, strict=True):
            if action < 0:
                break
            assert (node, action) not in failed or len(failed) > 5
            if node == led_to:
                failed.add((node, action))
    free = learn_from(ideal_graph(), trials(400), settings)
    assert done.solved.mean() > free.solved.mean() + 0.1


@pytest.mark.parametrize(
    ("wrong", "value"),
    [
        ("root", np.zeros(3)),
        ("root", np.full(4, 8)),
        ("image", np.full(4, 4)),
        ("image", np.full(4, -1)),
        ("phase", np.ones(4)),
        ("visual", np.zeros((4, 99))),
        ("draws", np.zeros((4, 10, 1))),
        ("draws", np.zeros((4, 128, 2))),
        ("draws", np.zeros((4, 0, 2))),
    ],
)
def test_compiled_code_gets_arrays_that_fit_only(wrong, value):
    with pytest.raises(InvalidValue, match=r"shape|to \d+"):
        run_frozen(LinearQ(), ideal_graph(), trials(**{wrong: value}))


@pytest.mark.parametrize("images", [[-1, 1, 0, 0], [0, 1, 0, 9], [0, 4, 0, 0]])
def test_the_number_that_does_not_fit_is_named(images):
    wrong = next(image for image in images if not 0 <= image < 4)
    with pytest.raises(InvalidValue, match=f"^images is {wrong}; expected 0 to 3$"):
        run_frozen(LinearQ(), ideal_graph(), trials(image=np.array(images)))


def test_learner_and_graph_must_fit_too():
    graph = ideal_graph()
    for size, what in (
        ({"n_features": 302}, "features"),
        ({"n_actions": 5}, "actions"),
    ):
        with pytest.raises(InvalidValue, match=f"number of {what}"):
            learn_from(graph, trials(), LinearSettings(**size))
    with pytest.raises(InvalidValue, match="states"):
        learn_from(graph._replace(state=np.ones(8, np.int32)), trials())
    with pytest.raises(InvalidValue, match="haptic states is 3; expected 0 to 2"):
        learn_from(graph._replace(haptic=np.full(8, 3)), trials())


def test_a_trials_phase_is_that_of_its_schedule():
    supervisor = Supervisor("none", ("swap-left-to-right:2", "swap-right-to-left:4"))
    assert phases(supervisor, range(6)).tolist() == [0, 0, 1, 1, 2, 2]
    assert phases(Supervisor(), range(3)).tolist() == [0, 0, 0]


def test_a_disabled_action_is_not_taken_before_its_trial(odd):
    settings = PopulationSettings(shaping=("grasp-right:50",), learner=FAST)
    done = learn(Programme(odd, Scenario(120), settings), 0)
    grasped = (done.action == 1).any(axis=1)
    assert not grasped[:50].any()
    assert grasped[50:].any()


def test_a_productive_supervisor_offers_nothing_that_would_not_run():
    good = recording(left=(ideal,), right=(ideal,))
    settings = PopulationSettings(supervisor="productive", learner=FAST)
    done = learn(Programme(good, Scenario(100), settings), 0)
    np.testing.assert_array_equal(done.executed, done.action >= 0)
