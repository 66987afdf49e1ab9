"""Choosing a learner and the rule for failed actions on the command line."""

import shutil

import pytest
from ideal_env import IdealEnv

from prospect_mj.agent import ReplaySettings, TableSettings
from prospect_mj.agent.learners import NAMES, SETTINGS
from prospect_mj.cli import train
from prospect_mj.cli.learner_options import named_learner
from prospect_mj.experiment.view.run_view import RunView


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def trained(options):
    """The configuration of a run that the options make."""
    assert train.main([*options.split(), "--trials", "1"], make_env=IdealEnv) == 0
    return RunView.read(train.Path("x")).config


BAD = {
    "--learner clever": "--learner is 'clever'; valid: linear, replay, table, discov",
    "--learner=clever": "--learner is 'clever'; valid: linear, replay, table, discov",
    "--learner": "--learner is given without a value",
    "--failed-actions never": "--failed-actions is 'never'; valid: allowed, suppressed",
    "--learner table --learner.surprise 1": "--learner.surprise",
    "--learner.replays 3": "--learner.replays",
    "--learner replay --learner.replays -1": "-1",
    "--learner replay --learner.buffer 0": "0",
    "--learner table --learner.n-haptic 4": "--learner.n-haptic",
    "--learner table --learner.known-correction": "copied_habit",
    "--resume run --learner table": "its learner is linear, not table",
    "--resume run --failed-actions suppressed": "failed_actions is allowed, not supp",
}


@pytest.mark.parametrize(("options", "named"), BAD.items(), ids=BAD.keys())
def test_bad_input_is_one_line_and_changes_nothing(options, named, existing, refused):
    assert named in refused(lambda: train.main(options.split(), make_env=IdealEnv))


@pytest.mark.parametrize("name", NAMES)
def test_every_learner_can_be_named(name):
    config = trained(f"--learner {name} --out x")
    assert config.learner == SETTINGS[name]()
    assert config.failed_actions == "allowed"


def test_a_learner_has_its_own_parameters():
    options = "--learner.replays 2 --out x --learner replay --learner.buffer 50"
    config = trained(f"{options} --learner.discount 0.9 --failed-actions suppressed")
    assert config.learner == ReplaySettings(replays=2, buffer=50, discount=0.9)
    assert config.failed_actions == "suppressed"


def test_flags_of_a_learner():
    options = "--learner.copied-habit --learner.known-correction"
    config = trained(f"--learner table {options} --out x")
    assert config.learner == TableSettings(copied_habit=True, known_correction=True)


def test_a_resumed_run_needs_no_learner_named_again():
    trained("--learner table --learner.step-size 0.3 --out x")
    again = ["--resume", "x", "--trials", "2"]
    assert train.main(again, make_env=IdealEnv) == 0
    view = RunView.read(train.Path("x"))
    assert view.learner.settings == TableSettings(step_size=0.3)
    assert view.n_trials == 2


def test_a_learner_of_another_kind_in_the_folder_is_one_line(existing, refused):
    trained("--learner table --out x")
    shutil.copy("x/weights.npz", "run")
    again = ["--resume", "run", "--trials", "5"]
    line = refused(lambda: train.main(again, make_env=IdealEnv))
    assert line == "error: run/weights.npz holds a table learner, not linear"


@pytest.mark.parametrize("name", NAMES)
def test_help_has_the_parameters_of_the_learner_that_is_named(name, capsys):
    with pytest.raises(SystemExit):
        train.main(["--learner", name, "--help"])
    words = capsys.readouterr().out
    own = {"replay": "--learner.buffer", "discovery": "--learner.surprise"}
    own |= {"linear": "--learner.initial-sd", "table": "--learner.copied-habit"}
    assert own[name] in words
    assert "--learner.n-" not in words
    assert ("--learner.surprise" in words) == (name == "discovery")


@pytest.mark.parametrize(
    ("words", "named"),
    [
        ([], None),
        (["--seed", "3"], None),
        (["--learner", "table"], "table"),
        (["--learner=table", "--learner", "replay"], "replay"),
        (["--learner", "clever"], None),
        (["--seed", "3", "--learner"], None),
        (["--learner.step-size", "table"], None),
    ],
)
def test_the_learner_is_looked_for_before_the_options_are_parsed(words, named):
    assert named_learner(words) == named
