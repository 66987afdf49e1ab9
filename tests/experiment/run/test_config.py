import dataclasses
import json
import subprocess
import sys
from typing import get_args

import pytest

from prospect_mj.agent import FeatureSettings, LinearSettings
from prospect_mj.control import arm_control
from prospect_mj.errors import ProspectError
from prospect_mj.experiment.run import config
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.task import pick_place


def test_defaults_are_the_papers_run_without_a_dominant_hand():
    run = TrainConfig()
    assert (run.trials, run.pretrain, run.max_actions) == (1000, 0, 10)
    assert (run.supervisor, run.object_pose) == ("none", "vision")
    assert run.bootstrap_at_truncation


def test_dictionary_round_trip():
    run = TrainConfig(
        trials=30,
        pretrain=7,
        dominant="left",
        seed=2**40,
        shaping=("swap-left-to-right:200", "insert-left:3"),
        features=FeatureSettings(reading="one_hot"),
        learner=LinearSettings(epsilon=0.1),
    )
    assert TrainConfig.from_dict(dataclasses.asdict(run)) == run
    read_back = json.loads(json.dumps(dataclasses.asdict(run)))
    assert TrainConfig.from_dict(read_back) == run


@pytest.mark.parametrize(
    ("bad", "named"),
    [
        ({"trials": 0}, "0"),
        ({"trials": 10**9}, "100000"),
        ({"trials": 2.5}, "2.5"),
        ({"pretrain": -1}, "-1"),
        ({"pretrain": True}, "pretrain is True; expected an integer"),
        ({"bootstrap_at_truncation": "no"}, "'no'; expected true or false"),
        ({"pretrain": 1001}, "1000"),
        ({"seed": -1}, "-1"),
        ({"max_actions": 0}, "0"),
        ({"dominant": "both"}, "left, right"),
        ({"supervisor": "strict"}, "none, safe, productive"),
        ({"object_pose": "guess"}, "vision, truth"),
        ({"world": "moon"}, "world is 'moon'; valid: standard, post"),
        ({"shaping": ("push-left:3",)}, "grasp-left, grasp-right, swap-left-to-right"),
        ({"shaping": ("grasp-left:-1",)}, "trials of grasp-left in shaping is '-1'"),
        ({"shaping": ("grasp-left",)}, "<action>:<trials>"),
        ({"shaping": ("grasp-left:1", "grasp-left:2")}, "each action once"),
        (
            {
                "supervisor": "productive",
                "shaping": ("grasp-left:5", "grasp-right:9"),
            },
            "something to choose in mode productive",
        ),
        ({"learner": LinearSettings(n_actions=5)}, "6"),
        ({"learner": LinearSettings(n_features=100)}, "303"),
    ],
)
def test_bad_values_are_named(bad, named):
    with pytest.raises(ProspectError) as refused:
        TrainConfig(**bad)
    assert named in str(refused.value)


@pytest.mark.parametrize(
    "change",
    [
        {"trials": "many"},
        {"trials": None},
        {"learner": {"epsilon": "small"}},
        {"learner": {"alpha": 1}},
        {"features": 3},
        {"colour": "red"},
        {"shaping": 3},
    ],
)
def test_foreign_dictionaries_are_refused(change):
    plain = {**dataclasses.asdict(TrainConfig()), **change}
    with pytest.raises(ProspectError):
        TrainConfig.from_dict(plain)


def test_choices_are_those_of_the_task():
    assert get_args(config.ObjectPose) == get_args(pick_place.ObjectPose)
    assert get_args(config.GrossMotion) == get_args(arm_control.GrossMotion)


def test_configuration_is_read_without_the_physics():
    """What the choices are written twice for."""
    code = (
        "import sys, prospect_mj.cli.train as t; t.main(['--trials', '0']); "
        "assert 'mujoco' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_missing_setting_is_refused():
    plain = dataclasses.asdict(TrainConfig())
    del plain["seed"]
    with pytest.raises(ProspectError):
        TrainConfig.from_dict(plain)


def test_every_setting_has_its_documentation():
    # tyro shows these texts; a setting without one would have an empty help.
    source = TrainConfig.__module__
    text = __import__(source, fromlist=["x"]).__loader__.get_source(source)
    for setting in dataclasses.fields(TrainConfig):
        declared = text.index(f"    {setting.name}: ")
        following = text[declared:].splitlines()[1]
        assert following.lstrip().startswith('"""'), setting.name
