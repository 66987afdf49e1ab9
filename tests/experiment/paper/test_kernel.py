"""The compiled learner against the readable one."""

import numpy as np
import pytest
from ideal_recording import clumsy, ideal, one_handed, recording, unseen

from prospect_mj.agent import FeatureSettings, LearnerSettings
from prospect_mj.errors import InvalidValue, RecordingError
from prospect_mj.experiment.paper.populations.compiled_learner import (
    run_frozen,
    run_trials,
)
from prospect_mj.experiment.paper.populations.kernel import Trials
from prospect_mj.experiment.paper.populations.outcome_graph import (
    HANDS,
    ideal_graph,
    ideal_root,
)
from prospect_mj.experiment.paper.populations.plain import learn_plainly
from prospect_mj.experiment.paper.populations.population import learn
from prospect_mj.experiment.paper.populations.programme import Programme
from prospect_mj.experiment.paper.populations.scenario import (
    PopulationSettings,
    Scenario,
)
from prospect_mj.recording.choices import phases
from prospect_mj.recording.recording import Recording
from prospect_mj.supervisor.supervisor import Supervisor

FAST = LearnerSettings(step_size=0.02, epsilon=0.1, initial_sd=0.0)
LEFT, RIGHT = HANDS


@pytest.fixture(scope="module")
def odd():
    """A recording in which much goes wrong."""
    kinds = (ideal, clumsy, one_handed, unseen, ideal)
    return recording(left=kinds, right=kinds)


def assert_equal_learners(compiled, plain):
    """To the last bit."""
    for name, of_plain in plain._asdict().items():
        np.testing.assert_array_equal(getattr(compiled, name), of_plain, name)


@pytest.mark.parametrize(
    "settings",
    [
        {},
        {"learner": LearnerSettings(step_size=0.3, epsilon=0.3, discount=0.9)},
        {"features": FeatureSettings(reading="one_hot")},
        {"features": FeatureSettings(normalisation="max_bin")},
        {"bootstrap_at_truncation": False, "max_actions": 5},
        {"supervisor": "productive"},
        {"supervisor": "safe", "shaping": ("insert-left:40", "grasp-right:90")},
        {"learner": LearnerSettings(step_size=0.02, initial_sd=1.0)},
        {"image_noise": 0.05},
        {"pictures": "one_per_side", "image_noise": 0.01},
    ],
    ids=lambda settings: "-".join(settings) or "default",
)
def test_compiled_learner_is_linear_q_on_a_recorded_task(odd, settings):
    settings = PopulationSettings(**({"learner": FAST} | settings))
    programme = Programme(odd, Scenario(150, pretrain=30), settings)
    for number in range(2):
        compiled, plain = learn(programme, number), learn_plainly(programme, number)
        assert_equal_learners(compiled, plain)
        assert 0 < np.count_nonzero(compiled.solved) < 150
        assert np.count_nonzero(compiled.executed) < compiled.n_actions.sum()


def test_ties_are_broken_alike_through_whole_runs_of_the_papers_learner():
    # Equal pictures in many trials make equal values of different histories.
    once = recording(left=(ideal,), right=(ideal,))
    settings = PopulationSettings(learner=LearnerSettings(initial_sd=0.0))
    programme = Programme(once, Scenario(400), settings)
    for number in range(6):
        compiled, plain = learn(programme, number), learn_plainly(programme, number)
        assert_equal_learners(compiled, plain)


def test_compiled_learner_is_linear_q_on_the_shipped_recording():
    programme = Programme(Recording.load(), Scenario(500, 200), PopulationSettings())
    compiled, plain = learn(programme, 0), learn_plainly(programme, 0)
    assert_equal_learners(compiled, plain)


def trials(n_trials=4, **changes):
    arrays = {
        "root": np.array([ideal_root(LEFT), ideal_root(RIGHT)] * (n_trials // 2)),
        "image": np.arange(n_trials),
        "visual": np.full((n_trials, 100), 0.1),
        "phase": np.zeros(n_trials),
        "draws": np.random.default_rng(0).random((n_trials, 10, 2)),
    }
    kinds = dict.fromkeys(("root", "image", "phase"), np.int32)
    arrays |= changes
    return Trials(**{k: v.astype(kinds.get(k, float)) for k, v in arrays.items()})


def test_an_outcome_that_was_not_recorded_is_an_error():
    graph = ideal_graph()
    graph.child[ideal_root(RIGHT), :] = -1
    with pytest.raises(RecordingError, match="trial 1 was not recorded"):
        run_trials(np.zeros((6, 303)), graph, trials(), FAST)


def test_a_learner_that_diverges_is_an_error():
    graph, bright = ideal_graph(), np.full((400, 100), 1000.0)
    with pytest.raises(InvalidValue, match="temporal-difference error of trial"):
        run_trials(np.zeros((6, 303)), graph, trials(400, visual=bright), FAST)


def test_a_value_that_is_no_number_is_an_error():
    weights = np.zeros((6, 303))
    weights[3, 302] = np.nan
    with pytest.raises(InvalidValue, match="NaN"):
        run_frozen(weights, ideal_graph(), trials())


def test_nothing_to_choose_from_is_an_error():
    choices = np.ones((2, 3, 6), bool)
    choices[1, 2] = False
    graph = ideal_graph()._replace(choices=choices)
    words = r"choice set of state 2 in phase 1 is \[\]; expected an action at least"
    with pytest.raises(InvalidValue, match=words):
        run_frozen(np.zeros((6, 303)), graph, trials())
    choices[1, 2, 5] = True
    run_frozen(np.zeros((6, 303)), graph, trials())


def test_frozen_policy_is_greedy_and_learns_nothing():
    weights = np.zeros((6, 303))
    weights[0, 302], weights[4, 300] = 1.0, 2.0  # Grasp left, insert left.
    before = weights.copy()
    done = run_frozen(weights, ideal_graph(), trials())
    np.testing.assert_array_equal(weights, before)
    assert done.n_actions.tolist() == [2, 10, 2, 10]
    assert done.solved.tolist() == [True, False, True, False]
    assert done.action[0].tolist() == [0, 4] + [-1] * 8
    assert done.action[1].tolist() == [0] + [4] * 9
    # Left of the ideal graph: the jar lies, in the left hand, in the right, inserted.
    assert done.node[0].tolist() == [1, 3] + [-1] * 8
    assert done.node[1].tolist() == [5] * 10


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
        run_frozen(np.zeros((6, 303)), ideal_graph(), trials(**{wrong: value}))


@pytest.mark.parametrize("images", [[-1, 1, 0, 0], [0, 1, 0, 9], [0, 4, 0, 0]])
def test_the_number_that_does_not_fit_is_named(images):
    wrong = next(image for image in images if not 0 <= image < 4)
    with pytest.raises(InvalidValue, match=f"^images is {wrong}; expected 0 to 3$"):
        run_frozen(np.zeros((6, 303)), ideal_graph(), trials(image=np.array(images)))


def test_weights_and_graph_must_fit_too():
    with pytest.raises(InvalidValue, match="shape of weights"):
        run_frozen(np.zeros((6, 302)), ideal_graph(), trials())
    graph = ideal_graph()
    with pytest.raises(InvalidValue, match="states"):
        run_frozen(
            np.zeros((6, 303)),
            graph._replace(state=np.ones(8, np.int32)),
            trials(),
        )


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
