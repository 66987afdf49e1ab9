"""Training with categories of grasps from the command line."""

import json
from pathlib import Path

import pytest
from felt_models import THREE, models
from ideal_env import IdealEnv

from prospect_mj.agent import TableSettings
from prospect_mj.agent.learners import NAMES, SETTINGS, with_categories
from prospect_mj.cli import train
from prospect_mj.experiment.view.run_view import RunView


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    THREE.write(Path("three.json"))
    models(0.005, 0.013).write(Path("two.json"))
    Path("bad.json").write_text(json.dumps({"weight": 3}))


def trained(options):
    """The configuration of a run that the options make."""
    assert train.main([*options.split(), "--trials", "1"], make_env=IdealEnv) == 0
    return RunView.read(Path("x")).config


BAD = {
    "--haptic-models": "--haptic-models is given without a value",
    "--haptic-models nowhere.json": "--haptic-models is 'nowhere.json'; expected a fi",
    "--haptic-models bad.json": "--haptic-models is 'bad.json'; expected a file of ha",
    "--haptic-models .": "--haptic-models is '.'; expected a file of haptic models",
    "--haptic-models three.json --learner.n-features 606": "--learner.n-features",
    "--resume run --haptic-models three.json": "run is another run: its haptic models",
}


@pytest.mark.parametrize(("options", "named"), BAD.items(), ids=BAD.keys())
def test_bad_input_is_one_line_and_changes_nothing(options, named, existing, refused):
    line = refused(lambda: train.main(options.split(), make_env=IdealEnv))
    assert named in line


@pytest.mark.parametrize("name", NAMES)
def test_every_learner_has_the_size_of_the_states(name):
    config = trained(f"--haptic-models three.json --learner {name} --out x")
    assert config.haptic_models == THREE
    assert config.learner == with_categories(SETTINGS[name](), 3)


@pytest.mark.parametrize("again", ["", "--haptic-models three.json"])
def test_a_resumed_run_has_the_models_that_it_began_with(again):
    trained(
        "--learner table --learner.step-size 0.3 --haptic-models three.json --out x"
    )
    argv = ["--resume", "x", "--trials", "2", *again.split()]
    assert train.main(argv, make_env=IdealEnv) == 0
    view = RunView.read(Path("x"))
    assert view.config.haptic_models == THREE
    assert view.learner.settings == TableSettings(step_size=0.3, n_haptic=7)
    assert view.n_trials == 2


@pytest.mark.parametrize(
    ("other", "named"),
    [
        ("--haptic-models two.json", "its haptic models are others"),
        ("--learner table", "its learner is linear, not table"),
    ],
)
def test_a_resumed_run_with_others_is_refused(other, named, refused):
    trained("--haptic-models three.json --out x")
    argv = ["--resume", "x", "--trials", "2", *other.split()]
    assert named in refused(lambda: train.main(argv, make_env=IdealEnv))


def test_runs_of_several_seeds_have_the_models(capsys):
    options = "--haptic-models three.json --learner replay --seeds 0:2 --jobs 1"
    argv = [*options.split(), "--trials", "2", "--out", "s"]
    for _ in range(2):
        assert train.main(argv, make_env=IdealEnv) == 0
    for seed in range(2):
        config = RunView.read(Path("s") / f"seed-{seed:04}").config
        assert config.haptic_models == THREE
        assert config.learner.n_features == 606


def test_help_names_the_option(capsys):
    with pytest.raises(SystemExit):
        train.main(["--help"])
    assert "--haptic-models FILE" in capsys.readouterr().out
