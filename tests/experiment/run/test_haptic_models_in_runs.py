"""Runs whose state tells categories of grasps: every learner, resumed and evaluated."""

from dataclasses import asdict, replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from felt_models import THREE, models
from ideal_env import IdealEnv

from prospect_mj.agent.learners import NAMES, SETTINGS, with_categories
from prospect_mj.envs.pick_place import PickPlaceEnv
from prospect_mj.errors import InvalidValue, ProspectError, RunFolderError
from prospect_mj.experiment.evaluation.evaluate import evaluate
from prospect_mj.experiment.run import fingerprint, session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import make_environment
from prospect_mj.experiment.run.training import new_learner, train
from prospect_mj.experiment.view.evaluation_settings import EvaluationSettings
from prospect_mj.experiment.view.run_view import RunView

QUIET = {"say": lambda _: None}
make_env = partial(IdealEnv, noise=0.1)


@pytest.fixture(autouse=True)
def no_picture(monkeypatch):
    monkeypatch.setattr(session.plots, "learning_curve", lambda *_: b"a picture")


@pytest.fixture(scope="module")
def recorded():
    """One environment for all, as it takes a second to make."""
    return make_environment(config("linear", 1, physics="recorded"))


def config(name, trials, haptic_models=THREE, **settings):
    learner = with_categories(SETTINGS[name](), len(haptic_models))
    return TrainConfig(trials, learner=learner, haptic_models=haptic_models, **settings)


def content(folder):
    return {file.name: file.read_bytes() for file in Path(folder).iterdir()}


@pytest.mark.parametrize("name", NAMES)
def test_every_learner_learns_from_recorded_categories(name, recorded):
    """All haptic states are met, and the learner has values of each."""
    run = config(name, 60, physics="recorded", failed_actions="suppressed")
    learner, seen = new_learner(run), set()
    update = learner.update

    def spy(transition, rng):
        seen.add(transition.observation.haptic)
        return update(transition, rng)

    learner.update = spy
    finished = list(train(run, recorded, learner))
    assert seen == set(range(7))
    assert learner.n_updates == sum(len(one.actions) for one in finished)
    assert all(np.isfinite(array).all() for array in learner.state().values())


def test_the_environment_has_the_runs_models(recorded):
    assert isinstance(recorded, PickPlaceEnv)
    assert recorded.settings.haptic_models == THREE


@pytest.mark.parametrize("name", NAMES)
def test_a_resumed_run_is_the_same_to_the_last_bit(name, tmp_path):
    run = config(name, 8, pretrain=4, seed=4, supervisor="safe")
    session.start(run, tmp_path / "whole", make_env, **QUIET)
    stopped = tmp_path / "stopped"
    session.start(run.with_trials(5), stopped, make_env, **QUIET)
    session.resume(stopped, run, make_env, **QUIET)
    assert content(stopped) == content(tmp_path / "whole")
    view = RunView.read(stopped)
    assert view.config.haptic_models == THREE
    evaluated = evaluate(view, EvaluationSettings(trials=2), None, make_env, **QUIET)
    assert evaluated.config.haptic_models == THREE


@pytest.mark.parametrize("others", [None, models(0.005, 0.013)])
def test_a_run_with_other_models_is_another_run(others, tmp_path):
    run = config("linear", 2)
    session.start(run, tmp_path / "run", make_env, **QUIET)
    n_categories = 0 if others is None else len(others)
    learner = with_categories(run.learner, n_categories)
    wanted = replace(run, trials=3, learner=learner, haptic_models=others)
    with pytest.raises(RunFolderError, match="its haptic models are others"):
        session.resume(tmp_path / "run", wanted, make_env, **QUIET)


def test_models_are_part_of_a_runs_digest():
    found = {
        fingerprint.digests(config("table", 2, several))[fingerprint.CONFIGURATION]
        for several in (THREE, models(0.005, 0.009, 0.014))
    }
    assert len(found) == 2


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"haptic_models": THREE}, "number of features is 303; expected 606"),
        ({"haptic_models": "models.json"}, "haptic models is 'models.json'"),
        (
            {"haptic_models": THREE, "learner": SETTINGS["table"]()},
            "number of haptic states is 3; expected 7",
        ),
        (
            {"learner": with_categories(SETTINGS["discovery"](), 2)},
            "number of haptic states is 5; expected 3",
        ),
    ],
)
def test_a_learner_of_other_sizes_is_refused(settings, words):
    with pytest.raises(InvalidValue, match=words):
        TrainConfig(**settings)


@pytest.mark.parametrize(
    "plain", [{"weight": [1.0]}, {"weight": [0.0]}, 3, "x", {"weight": 1}]
)
def test_damaged_models_in_a_configuration_are_refused(plain):
    whole = asdict(config("linear", 2))
    assert TrainConfig.from_dict(whole) == config("linear", 2)
    with pytest.raises((ProspectError, KeyError)):
        TrainConfig.from_dict({**whole, "haptic_models": plain})
