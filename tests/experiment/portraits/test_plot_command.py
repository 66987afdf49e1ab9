"""`plot`: files, and one line for what can't be drawn."""

import os
import subprocess
import sys

import numpy as np
import pytest
from felt_models import THREE
from ideal_env import IdealEnv

from prospect_mj.agent import LinearSettings, TableSettings, checkpoint
from prospect_mj.agent.learners import with_categories
from prospect_mj.cli import new_file
from prospect_mj.cli.plot import main
from prospect_mj.episodes import episode_file
from prospect_mj.experiment.evaluation.evaluate import evaluate
from prospect_mj.experiment.portraits import (
    grasp_picture,
    strategy_picture,
    weights_picture,
)
from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.kept_episodes import path_of
from prospect_mj.experiment.run.run_folder import RunFolder
from prospect_mj.experiment.view.evaluation_settings import EvaluationSettings
from prospect_mj.experiment.view.run_view import RunView

ALWAYS = ["q_values.png", "strategies.png", "weights.png"]


@pytest.fixture
def run(tmp_path):
    path = tmp_path / "run"
    session.start(TrainConfig(trials=4), path, IdealEnv, say=lambda _: None)
    return path


@pytest.fixture
def unrendered(monkeypatch):
    """Files without pixels, where it only matters which there are."""
    for picture in (grasp_picture, strategy_picture, weights_picture):
        monkeypatch.setattr(picture, "png", lambda figure: b"PNG")


def refused(capsys, *arguments):
    """The one line on stderr."""
    assert main([str(argument) for argument in arguments]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    (line,) = err.splitlines()
    return line


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_pictures_go_into_the_runs_folder_and_say_what_is_missing(run, capsys):
    assert main([str(run)]) == 0
    assert names(run / "plots") == ALWAYS
    out, err = capsys.readouterr()
    assert sorted(out.split()) == [str(run / "plots" / name) for name in ALWAYS]
    assert "--record every=50" in err
    assert len(err.splitlines()) == 1


def test_weights_over_grey_levels_need_a_linear_learner(tmp_path, capsys, unrendered):
    path, config = tmp_path / "told", TrainConfig(trials=4, learner=TableSettings())
    session.start(config, path, IdealEnv, say=lambda _: None)
    assert main([str(path)]) == 0
    assert names(path / "plots") == ["q_values.png", "strategies.png"]
    said = capsys.readouterr().err.splitlines()
    why = "it needs a linear learner, and this is a table learner"
    assert said[0] == f"no weights.png: {why}"


def test_weights_of_categories_are_left_out_and_told_of(tmp_path, capsys, unrendered):
    learner = with_categories(LinearSettings(), len(THREE))
    config = TrainConfig(trials=4, learner=learner, haptic_models=THREE)
    path = tmp_path / "run"
    session.start(config, path, IdealEnv, say=lambda _: None)
    assert main([str(path)]) == 0
    said = capsys.readouterr().err.splitlines()
    assert said[0] == "weights.png leaves out the weights of the haptic categories"
    assert names(path / "plots") == ALWAYS


def test_a_run_that_was_drawn_goes_on(run):
    (run / "plots").mkdir()
    (run / "plots" / "weights.png").touch()
    config = TrainConfig(trials=6)
    assert session.resume(run, config, IdealEnv, say=lambda _: None).trials == 6


def test_nothing_is_overwritten(run, capsys):
    out = run.parent / "pictures"
    out.mkdir()
    (out / "weights.png").write_text("mine")
    line = refused(capsys, run, "--out", out)
    assert "not empty" in line
    assert "--out" in line
    assert names(out) == ["weights.png"]
    assert (out / "weights.png").read_text() == "mine"


def test_a_file_in_the_folders_place_is_named(run, capsys):
    line = refused(capsys, run, "--out", run / "config.yaml")
    assert "is not a folder" in line


@pytest.mark.parametrize("why", ["a link to nowhere", "no permission"])
def test_a_folder_that_cant_be_had_is_refused_before_the_work(
    why, run, capsys, monkeypatch
):
    """Simulated grasps can take minutes."""
    out = run.parent / "pictures"
    if why == "no permission":
        out.mkdir()
        monkeypatch.setattr(new_file, "_may_be_written", lambda folder: False)
    else:
        out.symlink_to("nowhere")
    assert str(out) in refused(capsys, run, "--out", out)
    assert not out.is_dir() or not names(out)


def test_what_is_no_run_is_named(tmp_path, capsys):
    assert "is not a run folder" in refused(capsys, tmp_path)
    assert "is not a run folder" in refused(capsys, tmp_path / "nowhere")
    assert not list(tmp_path.iterdir())


def test_an_evaluation_is_no_run(run, capsys):
    view, settings = RunView.read(run), EvaluationSettings(trials=2)
    shown = evaluate(view, settings, make_env=IdealEnv, say=lambda _: None)
    before = names(shown.path)
    assert "is an evaluation, not a run" in refused(capsys, shown.path)
    assert names(shown.path) == before


def test_a_damaged_run_is_named_and_nothing_is_written(run, capsys):
    (run / "trials.parquet").write_bytes(b"PAR1")
    assert "trials.parquet" in refused(capsys, run)
    assert not (run / "plots").exists()


def test_damaged_episodes_are_named_and_left_out(run, capsys, unrendered):
    (run / "episodes").mkdir()
    for number in (0, 2):
        path_of(run, number).write_bytes(b"PK")
    assert main([str(run)]) == 0
    assert names(run / "plots") == ALWAYS
    warning, missing = capsys.readouterr().err.splitlines()
    assert warning.startswith("warning: 2 of the 2 kept episodes left out: ")
    assert "trial-000000.npz can't be read" in warning
    assert "trial-000002.npz can't be read" in warning
    assert missing.startswith("no grasp_portraits.png: the kept episodes show no grasp")


def test_without_opengl_kept_episodes_are_refused_in_one_line(run):
    """MuJoCo, which they are read with, can't be loaded where its backend is none."""
    (run / "episodes").mkdir()
    path_of(run, 2).write_bytes(b"PK")
    plot = "import sys; from prospect_mj.cli import plot; sys.exit(plot.main())"
    done = subprocess.run(
        [sys.executable, "-c", plot, str(run)],
        env=os.environ | {"MUJOCO_GL": "nonsense"},
        capture_output=True,
        text=True,
        check=False,
    )
    (line,) = done.stderr.splitlines()
    assert "MUJOCO_GL=nonsense (invalid value" in line
    assert "set it to egl" in line
    assert done.returncode == 2
    assert not (run / "plots").exists()


def with_weights(run, factor):
    learner = RunView.read(run).learner
    learner.weights[:] = np.random.default_rng(0).normal(size=learner.weights.shape)
    learner.weights *= factor
    checkpoint.write(run / "weights.npz", learner, RunView.read(run).origin)


def test_huge_numbers_are_drawn_without_a_warning(run, capsys):
    with_weights(run, 1e250)
    assert main([str(run)]) == 0
    (line,) = capsys.readouterr().err.splitlines()
    assert "no grasp_portraits.png" in line


def test_numbers_that_overflow_are_one_line(run, capsys):
    with_weights(run, 1e306)
    assert "have grown to" in refused(capsys, run)
    assert not (run / "plots").exists()


def test_a_run_without_a_finished_trial_is_named(tmp_path, capsys):
    path = tmp_path / "young"
    with RunFolder.create(path, TrainConfig(trials=4)):
        assert "no finished trial yet" in refused(capsys, path)


@pytest.mark.parametrize("number", ["-1", "1001"])
def test_grasps_that_are_too_many_or_too_few_are_refused(run, capsys, number):
    assert "--grasps" in refused(capsys, run, "--grasps", number)


@pytest.mark.smoke
def test_recorded_physics_is_drawn_without_mujoco(tmp_path):
    """A machine that only learns needs no OpenGL to look at what it learned."""
    path = tmp_path / "run"
    recorded = TrainConfig(trials=3, physics="recorded")
    session.start(recorded, path, IdealEnv, say=lambda _: None)
    code = (
        "import sys\n"
        "from prospect_mj.cli import plot\n"
        f"assert plot.main([{str(path)!r}]) == 0\n"
        "assert 'mujoco' not in sys.modules"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True
    )
    assert "recorded physics has no episodes" in done.stderr
    assert names(path / "plots") == ALWAYS


@pytest.mark.gl
def test_grasps_of_a_run_that_kept_them_are_drawn(run, grasped, capsys):
    path = path_of(run, 1)
    path.parent.mkdir()
    episode_file.write(path, grasped[1], RunView.read(run).origin)
    assert main([str(run)]) == 0
    assert names(run / "plots") == sorted([*ALWAYS, "grasp_portraits.png"])
    assert capsys.readouterr().err == ""


@pytest.mark.gl
def test_an_episode_of_another_run_is_named(run, grasped, capsys, unrendered):
    for number, origin in ((1, "another"), (2, RunView.read(run).origin)):
        path = path_of(run, number)
        path.parent.mkdir(exist_ok=True)
        episode_file.write(path, grasped[1], origin)
    assert main([str(run)]) == 0
    assert "grasp_portraits.png" in names(run / "plots")
    (line,) = capsys.readouterr().err.splitlines()
    assert "1 of the 2 kept episodes left out" in line
    assert "trial-000001.npz is from another run" in line
