"""The compiled learners against the readable ones, to the last bit."""

from dataclasses import replace

import numpy as np
import pytest
from ideal_recording import clumsy, ideal, one_handed, recording, unseen

from prospect_mj.agent import (
    FeatureSettings,
    LinearSettings,
    ReplaySettings,
    TableSettings,
)
from prospect_mj.experiment.populations.plain import learn_plainly
from prospect_mj.experiment.populations.population import learn
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.recording.recording import Recording

FAST = LinearSettings(step_size=0.02, epsilon=0.1, initial_sd=0.0)
LEARNERS = {
    "linear": FAST,
    "replay": ReplaySettings(replays=3, buffer=100, epsilon=0.1),
    "no replay": ReplaySettings(replays=0, epsilon=0.1),
    "table": TableSettings(epsilon=0.1),
    "table with replay": TableSettings(replays=4, buffer=70, epsilon=0.1),
    "replay that forgets": ReplaySettings(
        replays=3, buffer=100, epsilon=0.1, replays_forget=True
    ),
    "table that forgets": TableSettings(
        replays=4, buffer=70, epsilon=0.1, replays_forget=True
    ),
    "table that copies": TableSettings(copied_habit=True, replays=1, epsilon=0.1),
    "table that knows": TableSettings(
        copied_habit=True, known_correction=True, epsilon=0.1
    ),
}
RULES = ("allowed", "suppressed")


@pytest.fixture(scope="module")
def odd():
    """A recording in which much goes wrong."""
    kinds = (ideal, clumsy, one_handed, unseen, ideal)
    return recording(left=kinds, right=kinds)


@pytest.fixture(scope="module")
def shipped():
    return Recording.load()


def assert_equal_learners(compiled, plain):
    """What they did, and all that they have learned and remember, to the last bit."""
    for name, of_plain in plain._asdict().items():
        if name != "learner":
            np.testing.assert_array_equal(getattr(compiled, name), of_plain, name)
    states = [learned.learner.state() for learned in (compiled, plain)]
    assert states[0].keys() == states[1].keys()
    for name, of_plain in states[1].items():
        np.testing.assert_array_equal(states[0][name], of_plain, name)


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("learner", LEARNERS)
def test_every_twin_is_its_learner_under_either_rule(odd, learner, rule):
    settings = PopulationSettings(learner=LEARNERS[learner], failed_actions=rule)
    programme = Programme(odd, Scenario(150, pretrain=30), settings)
    compiled, plain = learn(programme, 0), learn_plainly(programme, 0)
    assert_equal_learners(compiled, plain)
    assert 0 < np.count_nonzero(compiled.solved) < 150
    # What fails is run again where that is allowed, unless all has failed.
    again = compiled.action[:, 1:] == compiled.action[:, :-1]
    assert np.mean(again[compiled.action[:, 1:] >= 0]) > 0.01


@pytest.mark.parametrize(
    "settings",
    [
        {},
        {"learner": LinearSettings(step_size=0.3, epsilon=0.3, discount=0.9)},
        {"features": FeatureSettings(reading="one_hot")},
        {"features": FeatureSettings(normalisation="max_bin")},
        {"bootstrap_at_truncation": False, "max_actions": 5},
        {"supervisor": "productive"},
        {"supervisor": "safe", "shaping": ("insert-left:40", "grasp-right:90")},
        {"learner": LinearSettings(step_size=0.02, initial_sd=1.0)},
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
    settings = PopulationSettings(learner=LinearSettings(initial_sd=0.0))
    programme = Programme(once, Scenario(400), settings)
    for number in range(6):
        compiled, plain = learn(programme, number), learn_plainly(programme, number)
        assert_equal_learners(compiled, plain)


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize(
    "learner", [LinearSettings(), ReplaySettings(), TableSettings()]
)
def test_twins_are_their_learners_on_the_shipped_recording(shipped, learner, rule):
    settings = PopulationSettings(learner=learner, failed_actions=rule)
    programme = Programme(shipped, Scenario(250, 100), settings)
    compiled, plain = learn(programme, 0), learn_plainly(programme, 0)
    assert_equal_learners(compiled, plain)


def with_categories(recorded, categories):
    """Any category in any node: what a learner is told need not be true."""
    rng = np.random.default_rng(1)
    category = rng.integers(0, categories, len(recorded.nodes.child))
    return RecordedWorld(recorded, categories, category)


@pytest.mark.parametrize("reading", ["product", "one_hot"])
@pytest.mark.parametrize("categories", [1, 2, 5])
@pytest.mark.parametrize("learner", ["linear", "replay", "table that knows"])
def test_twins_know_categories_of_grasps(odd, learner, categories, reading):
    size = {"n_features": 101 * (3 + categories)}
    if learner.startswith("table"):
        size = {"n_haptic": 1 + 2 * categories}
    settings = PopulationSettings(
        learner=replace(LEARNERS[learner], **size),
        categories=categories,
        failed_actions="suppressed",
        features=FeatureSettings(reading=reading),
    )
    world = with_categories(odd, categories)
    programme = Programme(world, Scenario(60, pretrain=20), settings)
    compiled, plain = learn(programme, 0), learn_plainly(programme, 0)
    assert_equal_learners(compiled, plain)
    assert compiled.splits.shape == (1 + 2 * categories, 6)
    assert set(programme.graph.haptic) == set(range(1 + 2 * categories))


@pytest.mark.parametrize("learner", ["linear", "replay", "table with replay"])
def test_twins_go_on_in_a_second_world(odd, learner):
    settings = PopulationSettings(learner=LEARNERS[learner], supervisor="safe")
    scenario = Scenario(80, pretrain=30, then_trials=70)
    then = recording(left=(clumsy, ideal), right=(one_handed,))
    programme = Programme(odd, scenario, settings, then)
    compiled, plain = learn(programme, 1), learn_plainly(programme, 1)
    assert_equal_learners(compiled, plain)
    assert len(compiled.lid) == 150
