import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from folder_tree import tree
from ideal_env import IdealEnv

from prospect_mj.cli import train
from prospect_mj.errors import MissingFile, RenderingUnavailable, UnforeseenEvent

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


BAD = {
    "--trails 5": "--trails",
    "5": "5",
    "--trials": "--trials",
    "--trials five": "five",
    "--trials 0": "0",
    "--trials -3": "-3",
    "--trials 2.5": "2.5",
    "--trials 99999999999": "100000",
    "--pretrain -1": "-1",
    "--trials 10 --pretrain 11": "11",
    "--seed -1": "-1",
    "--seed 1e400": "1e400",
    "--dominant both": "both",
    "--supervisor strict": "strict",
    "--shaping push-left:3": "grasp-left, grasp-right, swap-left-to-right",
    "--shaping grasp-left:-3": "'-3'; expected 0 or more",
    "--shaping grasp-left:3 grasp-left:4": "each action once",
    "--shaping grasp-left": "<action>:<trials>",
    "--supervisor productive --shaping grasp-left:9 grasp-right:9": "to choose",
    "--object-pose guess": "guess",
    "--max-actions 0": "0",
    "--learner.epsilon 1.5": "1.5",
    "--learner.epsilon nan": "nan",
    "--learner.step-size 0": "0",
    "--learner.step-size -1": "-1",
    "--learner.discount inf": "inf",
    "--learner.n-actions 7": "--learner.n-actions",
    "--features.energy -2": "-2",
    "--features.reading sum": "sum",
    "--features.normalisation l3": "l3",
    "--out full": "full is not empty",
    "--out run": "--resume run",
    "--out file": "file",
    "--out file/below": "file",
    "--resume nowhere": "nowhere",
    "--resume full": "full is not a run folder",
    "--resume file": "file is not a run folder",
    "--resume run --out new": "new",
    "--resume run --seed 2": "seed is 1, not 2",
    "--resume run --learner.epsilon 0.5": "learner.epsilon is 0.05, not 0.5",
    "--resume run --trials 2": "3 trials",
    "--resume run --supervisor safe": "supervisor",
    "--resume run --shaping insert-left:2": "shaping is (), not ('insert-left:2',)",
}


@pytest.mark.parametrize(("options", "named"), BAD.items(), ids=BAD.keys())
def test_bad_input_is_one_line_and_changes_nothing(options, named, existing, refused):
    line = refused(lambda: train.main(options.split(), make_env=IdealEnv))
    assert named in line
    assert "parsing" not in line


EDITED = {
    "energy: 2.4": "energy: 3.0",
    "seed: 1": "seed: 2",
    "supervisor: none": "supervisor: safe",
}


@pytest.mark.parametrize(("old", "new"), EDITED.items())
@pytest.mark.parametrize("options", ["--resume run", "--resume run --trials 5"])
def test_edited_configuration_is_one_line_and_changes_nothing(
    old, new, options, existing, refused
):
    path = existing / "run" / "config.yaml"
    path.write_text(path.read_text().replace(old, new))
    line = refused(lambda: train.main(options.split(), make_env=IdealEnv))
    assert line.startswith("error: run/config.yaml: its settings were edited")


def test_weights_of_another_run_are_one_line_and_change_nothing(existing, refused):
    assert (
        train.main(["--trials", "3", "--seed", "2", "--out", "b"], make_env=IdealEnv)
        == 0
    )
    shutil.copy(existing / "b" / "weights.npz", existing / "run")
    again = ["--resume", "run", "--trials", "5"]
    line = refused(lambda: train.main(again, make_env=IdealEnv))
    assert line == "error: run/weights.npz is from another run"


@pytest.mark.parametrize(
    "failure",
    [RenderingUnavailable("no OpenGL: install libegl1"), MissingFile("torso.xml")],
)
def test_broken_installation_is_one_line_and_no_folder(failure, tmp_path, capsys):
    def make_env(config):
        raise failure

    assert train.main(["--out", "new/run"], make_env=make_env) == 2
    assert train.main([], make_env=make_env) == 2
    assert capsys.readouterr().err == f"error: {failure}\n" * 2
    assert not tree(tmp_path)


def test_broken_installation_does_not_touch_a_run(existing, capsys):
    def make_env(config):
        raise RenderingUnavailable("no OpenGL")

    before = tree(existing)
    assert train.main(["--resume", "run", "--trials", "5"], make_env=make_env) == 2
    assert tree(existing) == before


def test_training_sums_up(existing, capsys):
    assert train.main(["--trials", "2"], make_env=IdealEnv) == 0
    said = capsys.readouterr()
    assert "mean actions" in said.out
    assert "runs/train-0001" in said.out
    assert said.err == ""


def test_resume_takes_the_stored_options(existing, capsys):
    assert train.main(["--resume", "run", "--trials", "5"], make_env=IdealEnv) == 0
    whole = ["--trials", "5", "--seed", "1", "--out", "whole"]
    assert train.main(whole, make_env=IdealEnv) == 0
    run, whole = tree(existing / "run"), tree(existing / "whole")
    assert list(run.values()) == list(whole.values())


def test_options_equal_to_the_stored_ones_are_no_contradiction(existing):
    again = ["--resume", "run", "--trials", "4", "--seed", "1", "--supervisor", "none"]
    assert train.main(again, make_env=IdealEnv) == 0


def test_resume_of_a_finished_run_says_so(existing, capsys):
    before = tree(existing)
    assert train.main(["--resume", "run"], make_env=IdealEnv) == 0
    assert "finished" in capsys.readouterr().out
    assert tree(existing) == before


def test_a_run_on_recorded_physics_keeps_no_episodes(existing, refused):
    begin = ["--physics", "recorded", "--trials", "2", "--out", "recorded"]
    assert train.main(begin, make_env=IdealEnv) == 0
    more = ["--resume", "recorded", "--trials", "4", "--record", "all"]
    line = refused(lambda: train.main(more, make_env=IdealEnv))
    assert "none on recorded physics" in line


def test_interrupted_run_can_be_resumed(tmp_path, capsys):
    class Interrupted(IdealEnv):
        left = 30

        def step(self, action):
            Interrupted.left -= 1
            if Interrupted.left < 0:
                raise KeyboardInterrupt
            return super().step(action)

    options = ["--trials", "10", "--seed", "3", "--out"]
    assert train.main([*options, "cut"], make_env=Interrupted) == 130
    assert "kept" in capsys.readouterr().err
    assert train.main(["--resume", "cut"], make_env=IdealEnv) == 0
    assert train.main([*options, "whole"], make_env=IdealEnv) == 0
    cut, whole = tree(tmp_path / "cut"), tree(tmp_path / "whole")
    assert list(cut.values()) == list(whole.values())


def test_a_shaped_run_goes_on_bit_identically(tmp_path):
    """Stopped before its schedule is lifted, it is lifted at the same trial."""
    shaping = ["--supervisor", "safe", "--shaping", "grasp-left:5", "insert-right:7"]
    options = ["--seed", "3", *shaping, "--out"]
    assert train.main(["--trials", "4", *options, "cut"], make_env=IdealEnv) == 0
    assert train.main(["--trials", "10", *options, "whole"], make_env=IdealEnv) == 0
    assert (
        train.main(
            ["--trials", "10", "--seed", "3", "--out", "plain"], make_env=IdealEnv
        )
        == 0
    )
    assert train.main(["--resume", "cut", "--trials", "10"], make_env=IdealEnv) == 0
    cut, whole = tree(tmp_path / "cut"), tree(tmp_path / "whole")
    assert list(cut.values()) == list(whole.values())
    plain = tree(tmp_path / "plain")
    assert plain[str(tmp_path / "plain" / "weights.npz")] not in whole.values()


def test_an_unforeseen_event_is_one_line_and_no_fault_of_the_input(tmp_path, capsys):
    class Surprising(IdealEnv):
        def step(self, action):
            raise UnforeseenEvent("jammed: left holds", "grasp-left from here")

    assert train.main(["--out", "run"], make_env=Surprising) == 1
    said = capsys.readouterr().err
    assert said == (
        "error: unforeseen event: jammed: left holds; it can't happen in: "
        "grasp-left from here\n"
    )


def test_every_option_of_the_issue_reaches_the_run(tmp_path):
    configs = []

    def make_env(config):
        configs.append(config)
        return IdealEnv(config)

    options = """--trials 2 --pretrain 1 --dominant left --seed 9 --out x
        --supervisor safe --object-pose truth --no-bootstrap-at-truncation
        --max-actions 4 --learner.step-size 0.01 --learner.epsilon 0.2
        --learner.discount 0.9 --features.reading one_hot
        --features.normalisation max_bin --features.energy 3
        --shaping swap-left-to-right:200 swap-right-to-left:100"""
    assert train.main(options.split(), make_env=make_env) == 0
    (config,) = configs
    assert (config.trials, config.pretrain, config.dominant) == (2, 1, "left")
    assert (config.supervisor, config.object_pose) == ("safe", "truth")
    assert (config.seed, config.max_actions) == (9, 4)
    assert config.shaping == ("swap-left-to-right:200", "swap-right-to-left:100")
    assert not config.bootstrap_at_truncation
    learner, features = config.learner, config.features
    assert (learner.step_size, learner.epsilon, learner.discount) == (0.01, 0.2, 0.9)
    assert (features.reading, features.normalisation) == ("one_hot", "max_bin")
    assert features.energy == 3


def run_script(*options):
    return subprocess.run(
        [sys.executable, ROOT / "scripts" / "train.py", *options],
        capture_output=True,
        text=True,
        check=False,
    )


def test_script_refuses_in_one_line(tmp_path):
    done = run_script("--trials", "-1")
    assert done.returncode == 2
    assert (
        done.stderr == "error: --trials is -1; expected an integer from 1 to 100000\n"
    )
    assert not tree(tmp_path)


def test_script_helps(tmp_path):
    done = run_script("--help")
    assert done.returncode == 0
    for option in ("--trials", "--pretrain", "--dominant", "--resume", "--supervisor"):
        assert option in done.stdout
