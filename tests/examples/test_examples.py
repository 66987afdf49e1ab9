"""The examples run, and their agents learn; `make agents` runs what needs torch."""

import re
import subprocess
import sys
import warnings
from pathlib import Path

import comparison
import gymnasium
import numpy as np
import own_agent
import pytest
import random_agent

import prospect_mj  # noqa: F401  (registers the environment)
from prospect_mj.cli import command_line

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
ENV_ID = "prospect_mj/PickPlace-v0"
FOREIGN = "ignore:the recording may differ from live physics"
REPORT = (
    r"mean actions of the last (\d+) of (\d+) trials: .+ (\d+\.\d\d), "
    r"the paper's learner \d+\.\d\d, optimum 2\n"
)


def run(name, *options):
    """Run an example as a user does; its standard output."""
    done = subprocess.run(
        [sys.executable, "-W", FOREIGN, EXAMPLES / f"{name}.py", *options],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def reported(output):
    """Number of trials, and the agent's mean over the last of them."""
    found = re.search(REPORT, output)
    assert found, output
    return int(found[2]), float(found[3])


def test_an_own_agent_learns():
    lengths = own_agent.train(own_agent.Options(trials=400))
    assert np.mean(lengths[:20]) > 5
    assert np.mean(lengths[-100:]) < 3
    assert lengths == own_agent.train(own_agent.Options(trials=400))
    assert lengths != own_agent.train(own_agent.Options(trials=400, seed=1))


def test_the_papers_learner_learns():
    lengths = comparison.paper_learner(1000, seed=0)
    assert np.mean(lengths[:20]) > 5
    assert np.mean(lengths[-100:]) < 2.5


def test_chance_is_better_off_with_the_supervisors_choice():
    options = random_agent.Options(trials=200)
    everything = random_agent.play(options, supervisor="none")
    useful = random_agent.play(options, supervisor="productive")
    assert np.mean(everything) > 7.5
    assert np.mean(useful) < 6.5


@pytest.mark.parametrize("name", ["random_agent", "own_agent"])
def test_an_example_runs_as_it_is(name):
    assert reported(run(name, "--trials=20"))[0] == 20


@pytest.mark.parametrize(
    ("option", "words"),
    [
        ("--trials=0", "--trials is 0; expected an integer from 1 to 1000000000"),
        ("--seed=-1", "from 0 to 1000000000"),
        ("--seed=5000000000", "from 0 to 1000000000"),
        ("--trials=many", "--trials is 'many'; expected a whole number"),
    ],
)
def test_a_number_that_cant_be_is_refused_in_one_line(option, words, capsys):
    agent = own_agent.main, own_agent.Options(), "own_agent.py"
    assert command_line.main(*agent, [option]) == 2
    told = capsys.readouterr().err
    assert told.startswith("error: ")
    assert told.endswith(f"{words}\n")
    assert told.count("\n") == 1


@pytest.mark.slow
@pytest.mark.usefixtures("agents")
@pytest.mark.parametrize("name", ["train_dqn_sb3", "train_maskable_ppo"])
def test_an_agent_of_stable_baselines3_learns(name):
    trials, mean = reported(run(name, "--steps=4000", "--seed=1"))
    assert trials > 500
    assert mean < 3.5


@pytest.mark.slow
@pytest.mark.gl
@pytest.mark.usefixtures("agents")
@pytest.mark.parametrize(
    "settings", [{"physics": "recorded"}, {}, {"observation": "images"}]
)
def test_stable_baselines3s_own_check_finds_nothing(settings):
    from stable_baselines3.common.env_checker import check_env

    env = gymnasium.make(ENV_ID, **settings)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env)
    env.close()


@pytest.mark.slow
@pytest.mark.usefixtures("agents")
def test_sb3_contrib_finds_the_masks_through_wrappers():
    from sb3_contrib.common.maskable.utils import (
        get_action_masks,
        is_masking_supported,
    )
    from stable_baselines3.common.env_util import make_vec_env

    settings = {"physics": "recorded", "supervisor": "productive"}
    envs = make_vec_env(ENV_ID, 3, env_kwargs=settings)
    envs.reset()
    assert is_masking_supported(envs)
    assert get_action_masks(envs).tolist() == [[True, True, *[False] * 4]] * 3
    single = gymnasium.make(ENV_ID, **settings)
    single.reset(seed=0)
    assert get_action_masks(single).tolist() == [True, True, *[False] * 4]


@pytest.mark.slow
@pytest.mark.gl
@pytest.mark.usefixtures("agents")
def test_gymnasiums_tools_make_videos(tmp_path):
    import cv2
    from gymnasium.utils.save_video import save_video
    from gymnasium.wrappers import RecordVideo

    size = {"width": 160, "height": 120}
    still = gymnasium.make(ENV_ID, render_mode="rgb_array", **size)
    shows = RecordVideo(still, tmp_path / "show", episode_trigger=lambda trial: True)
    film = gymnasium.make(ENV_ID, render_mode="rgb_array_list", **size)
    for env in (shows, film):
        env.reset(seed=0, options={"orientation": "left"})
        *_, told = env.step(0)
    rate = film.metadata["render_fps"]
    save_video(film.render(), tmp_path / "film", lambda trial: True, fps=rate)
    for env in (shows, film):
        env.close()
    seconds = {}
    for folder in ("show", "film"):
        (path,) = (tmp_path / folder).glob("*.mp4")
        video = cv2.VideoCapture(str(path))
        n_frames = video.get(cv2.CAP_PROP_FRAME_COUNT)
        seconds[folder] = n_frames / video.get(cv2.CAP_PROP_FPS)
        video.release()
    assert seconds["show"] == pytest.approx(2, abs=0.5)
    assert seconds["film"] == pytest.approx(told["sim_seconds"], abs=0.5)
