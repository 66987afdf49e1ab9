"""Every learner in a run: resumed, evaluated, under both rules for failed actions."""

import shutil
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from ideal_env import IdealEnv

from prospect_mj import paths
from prospect_mj.agent import TableSettings
from prospect_mj.agent.learners import NAMES, SETTINGS
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.evaluation.evaluate import evaluate
from prospect_mj.experiment.run import fingerprint, session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.training import new_learner, train
from prospect_mj.experiment.view.evaluation_settings import EvaluationSettings
from prospect_mj.experiment.view.run_view import RunView

QUIET = {"say": lambda _: None}
make_env = partial(IdealEnv, noise=0.1)


@pytest.fixture(autouse=True)
def no_picture(monkeypatch):
    monkeypatch.setattr(session.plots, "learning_curve", lambda *_: b"a picture")


def content(folder):
    return {file.name: file.read_bytes() for file in Path(folder).iterdir()}


@pytest.mark.parametrize("rule", ["allowed", "suppressed"])
@pytest.mark.parametrize("name", NAMES)
def test_a_resumed_run_is_the_same_to_the_last_bit(name, rule, tmp_path):
    config = TrainConfig(
        8, 4, seed=4, failed_actions=rule, learner=SETTINGS[name](), supervisor="safe"
    )
    session.start(config, tmp_path / "whole", make_env, **QUIET)
    stopped = tmp_path / "stopped"
    session.start(config.with_trials(5), stopped, make_env, **QUIET)
    session.resume(stopped, config, make_env, **QUIET)
    assert content(stopped) == content(tmp_path / "whole")
    view = RunView.read(stopped)
    assert view.learner.settings == SETTINGS[name]()
    assert view.learner.n_updates == view.actions.num_rows


def test_a_learner_of_another_kind_is_named(tmp_path):
    for name in ("linear", "table"):
        config = TrainConfig(2, learner=SETTINGS[name]())
        session.start(config, tmp_path / name, make_env, **QUIET)
    shutil.copy(tmp_path / "table" / "weights.npz", tmp_path / "linear")
    with pytest.raises(RunFolderError) as refused:
        RunView.read(tmp_path / "linear")
    path = tmp_path / "linear" / "weights.npz"
    assert str(refused.value) == f"{path} holds a table learner, not linear"


def settled(name, trials, **settings):
    """Mean actions of the last hundred trials."""
    config = TrainConfig(trials, seed=2, learner=SETTINGS[name](), **settings)
    finished = train(config, make_env(config), new_learner(config))
    return np.mean([one.trial.n_actions for one in finished][-100:])


@pytest.mark.parametrize("name", NAMES)
def test_every_learner_comes_near_the_optimum(name):
    trials = {"linear": 800, "replay": 250, "table": 400, "discovery": 700}[name]
    assert 2 <= settled(name, trials, failed_actions="suppressed") < 2.6


def test_a_table_has_no_use_for_the_picture():
    config = TrainConfig(60, seed=3, learner=TableSettings(replays=2))
    runs = [
        list(train(config, IdealEnv(config, noise=noise), new_learner(config)))
        for noise in (0.0, 0.9)
    ]
    assert runs[0] == runs[1]


def failed(actions):
    """(holding, action) of those that had no effect."""
    return [
        (a.holding, a.action)
        for a in actions
        if a.holding == a.next_holding and not a.inserted
    ]


@pytest.mark.parametrize("rule", ["allowed", "suppressed"])
def test_what_had_no_effect_is_run_again_only_where_that_is_allowed(rule):
    config = TrainConfig(60, seed=5, failed_actions=rule)
    finished = train(config, make_env(config), new_learner(config))
    again = sum(
        len(vain) - len(set(vain)) for vain in (failed(one.actions) for one in finished)
    )
    assert (again > 0) == (rule == "allowed")


def test_what_is_suppressed_is_no_target():
    """After a vain insertion its value can't be the best of what may follow."""
    config = TrainConfig(20, seed=6, failed_actions="suppressed")
    learner, told = new_learner(config), []
    update = learner.update

    def spy(transition, rng):
        told.append(transition)
        return update(transition, rng)

    learner.update = spy
    for _ in train(config, make_env(config), learner):
        pass
    vain = [
        one
        for one in told
        if one.observation.haptic == one.next_observation.haptic and not one.terminated
    ]
    assert len(vain) > 20
    assert not any(one.allowed[one.action] for one in vain)


def test_an_evaluation_keeps_the_rule_and_teaches_nothing(tmp_path):
    config = TrainConfig(
        3, seed=7, failed_actions="suppressed", learner=SETTINGS["replay"]()
    )
    session.start(config, tmp_path / "run", make_env, **QUIET)
    run = RunView.read(tmp_path / "run")
    view = evaluate(run, EvaluationSettings(trials=3), None, make_env, **QUIET)
    states = run.learner.state(), view.learner.state()
    for name, array in states[0].items():
        np.testing.assert_array_equal(array, states[1][name])
    assert not view.actions["explored"].to_numpy().any()
    for trial in range(view.n_trials):
        rows = view.actions_of(trial).to_pylist()
        vain = [
            (row["holding"], row["action"])
            for row in rows
            if row["holding"] == row["next_holding"] and not row["inserted"]
        ]
        assert len(vain) == len(set(vain))


def test_all_code_of_the_learners_counts():
    """A run can't be gone on with after a change of how its learner learns."""
    agent = Path(paths.__file__).parent / "agent"
    named = {name for kind in NAMES for name in fingerprint.learner_code(kind)}
    elsewhere = {"__init__", "checkpoint", "learner", "learners", "settings"}
    elsewhere.add("state_arrays")
    modules = {
        path.relative_to(agent.parent).as_posix()
        for path in agent.rglob("*.py")
        if path.stem not in elsewhere
    }
    assert modules == {name for name in named if not name.endswith("__init__.py")}
    digests = [fingerprint.learner_digest(kind) for kind in NAMES]
    assert len(set(digests)) == len(NAMES)
