import io
from pathlib import Path

import cv2
import numpy as np
import pytest
from ideal_env import IdealEnv

from prospect_mj.experiment.run import plots, session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.run_folder import RunFolder
from prospect_mj.experiment.run.summary import Summary


def picture(png):
    return cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR_RGB)


def has_colour(image, colour):
    wanted = [int(colour[start : start + 2], 16) for start in (1, 3, 5)]
    return bool((np.abs(image.astype(int) - wanted).max(axis=-1) <= 2).any())


@pytest.mark.parametrize(
    ("n_trials", "pretrain", "line"),
    [(1, 0, False), (7, 3, False), (49, 0, False), (300, 0, True), (300, 120, True)],
)
def test_learning_curve_shows_what_there_is(n_trials, pretrain, line):
    actions = np.linspace(9, 3, n_trials)
    image = picture(plots.learning_curve(actions, pretrain, 10, "a run"))
    assert image.shape == (675, 1200, 3)
    assert has_colour(image, plots._DOTS)
    assert has_colour(image, plots._LINE) == line
    assert has_colour(image, plots._SHADE) == bool(pretrain)


def test_learning_curve_is_the_same_every_time():
    drawings = {plots.learning_curve(np.arange(2, 9), 0, 10, "a run") for _ in range(2)}
    assert len(drawings) == 1


def train(tmp_path, config):
    return session.start(config, tmp_path / "run", IdealEnv, lambda _: None)


def test_summary_of_a_run(tmp_path):
    summary = train(tmp_path, TrainConfig(trials=60, pretrain=20))
    with RunFolder.open(tmp_path / "run") as folder:
        actions = folder.trials["n_actions"].to_numpy()
        seconds = folder.trials["sim_seconds"].to_numpy()
    assert summary.trials == 60
    assert summary.first_mean == pytest.approx(actions[:50].mean())
    assert summary.last_mean == pytest.approx(actions[-50:].mean())
    assert summary.sim_seconds == pytest.approx(seconds.sum())
    assert summary.session_sim_seconds == summary.sim_seconds
    assert summary.wall_seconds > 0
    text = str(summary)
    assert "60, 20 of them pretraining" in text
    assert "not measured: it takes 50 trials after the pretraining, not 40" in text
    assert str(tmp_path / "run") in text


def test_summary_of_a_resumed_run_counts_its_own_time(tmp_path):
    first = train(tmp_path, TrainConfig(trials=5))
    config = TrainConfig(trials=8)
    second = session.resume(tmp_path / "run", config, IdealEnv, lambda _: None)
    assert second.sim_seconds > first.sim_seconds
    assert second.session_sim_seconds == pytest.approx(
        second.sim_seconds - first.sim_seconds
    )


@pytest.mark.parametrize(
    ("trials", "pretrain", "said"),
    [
        (60, 60, "not measured: it takes 50 trials after the pretraining, not 0"),
        (49, 0, "not measured: it takes 50 trials, not 49"),
        (50, 0, "not reached (a mean of 2.4 over 50 trials)"),
    ],
)
def test_summary_tells_failure_from_too_few_trials(trials, pretrain, said):
    figures = (8.3, 7.0, None, 100.0, 100.0, 1.0, Path("run"))
    assert f"near-optimal  {said}\n" in str(Summary(trials, pretrain, *figures))


def test_summary_names_the_near_optimal_trials():
    summary = Summary(
        1000, 0, 8.3, 2.2, 612, 10_000.0, 10_000.0, 200.0, Path("runs/train-0001")
    )
    assert "trials 612 to 661" in str(summary)
    assert "(50 x)" in str(summary)


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_progress_on_a_terminal(tmp_path, monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr("sys.stderr", terminal)
    summary = train(tmp_path, TrainConfig(trials=12))
    last = terminal.getvalue().strip().splitlines()[-1].split("\r")[-1]
    assert "12/12" in last
    assert f"mean actions of last 12: {summary.last_mean:.2f}" in last


def test_progress_without_a_terminal_is_a_line_every_hundred_trials(tmp_path, capsys):
    train(tmp_path, TrainConfig(trials=205))
    with RunFolder.open(tmp_path / "run") as folder:
        actions = folder.trials["n_actions"].to_numpy()
    assert capsys.readouterr().err.splitlines() == [
        f"trial {n} of 205: mean actions of last 50: {actions[n - 50 : n].mean():.2f}"
        for n in (100, 200)
    ]
