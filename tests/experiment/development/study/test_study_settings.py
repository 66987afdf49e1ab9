"""What makes no study of development, and which worlds a study needs."""

import pytest

from prospect_mj.errors import InvalidValue, ProspectError
from prospect_mj.experiment.development.haptics.settings import HapticSettings
from prospect_mj.experiment.development.rivals.settings import RivalSettings
from prospect_mj.experiment.development.study.settings import (
    CHANGES,
    FELT_WORLDS,
    IMAGE_WORLDS,
    PARTS,
    Extent,
    StudySettings,
)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"runs": 0}, "runs is 0"),
        ({"runs": 1}, "runs is 1"),
        ({"runs": -4}, "runs is -4"),
        ({"runs": 10**9}, "runs is 1000000000"),
        ({"setting_runs": 1}, "setting_runs is 1"),
        ({"seed": -1}, "seed is -1"),
        ({"deep_runs": 0}, "deep_runs is 0"),
        ({"deep_trials": 49}, "deep_trials is 49"),
        ({"grasped": 6}, "grasped is 6"),
        ({"grasped": 4}, "grasped is 4"),
        ({"grasped": -4}, "grasped is -4"),
        ({"planned": 3}, "planned is 3"),
        ({"planned": 52}, "planned is 52"),
    ],
    ids=str,
)
def test_sizes_that_make_no_study_are_refused(settings, words):
    with pytest.raises(InvalidValue, match=words):
        StudySettings(**settings)


@pytest.mark.parametrize(
    ("runs", "given", "fewer"), [(1000, None, 400), (2, None, 2), (1000, 7, 7)]
)
def test_rows_of_large_tables_have_fewer_runs(runs, given, fewer):
    assert StudySettings(runs, given).fewer_runs == fewer


@pytest.mark.parametrize("grasped", [0, 8, 24])
@pytest.mark.parametrize("planned", [0, 2, 50])
def test_what_the_study_accepts_its_parts_accept(grasped, planned):
    made = StudySettings(runs=2, grasped=grasped, planned=planned)
    HapticSettings(grasped=made.grasped)
    RivalSettings(
        linear_runs=made.runs,
        deep_runs=made.deep_runs,
        deep_trials=made.deep_trials,
        live_presentations=made.planned // 2,
    )


@pytest.mark.parametrize(
    ("extent", "words"),
    [
        ({"parts": ("learners", "dance")}, "parts is 'dance'; valid: learners, causal"),
        ({"worlds": ("moon",)}, "worlds is 'moon'; valid: standard"),
        ({"changes": ("noisy",)}, "changes is 'noisy'; valid: post, lamp-right"),
        ({"parts": ()}, "parts"),
        ({"worlds": ("standard", "standard")}, "worlds"),
    ],
    ids=str,
)
def test_parts_and_worlds_that_are_not_there_are_refused(extent, words):
    with pytest.raises(ProspectError, match=words):
        Extent(**extent)


def test_recordings_are_asked_for_only_where_a_part_learns_from_them():
    everything = (*IMAGE_WORLDS, *CHANGES, *FELT_WORLDS)
    assert Extent().all_worlds == tuple(dict.fromkeys(everything))
    assert Extent(("haptics",)).all_worlds == FELT_WORLDS
    assert Extent(("learners", "rivals")).all_worlds == ("standard",)
    assert Extent(("worlds",), ("noisy",)).all_worlds == ("standard", "noisy")
    assert Extent(("change",), changes=("post",)).all_worlds == ("standard", "post")


def test_each_use_of_chance_has_a_stream_of_its_own():
    settings = StudySettings(seed=3)
    keys = [(part, row) for part in range(len(PARTS)) for row in range(20)]
    drawn = [settings.rng(*key).integers(2**63) for key in keys]
    assert len(set(drawn)) == len(keys)
    assert settings.rng(1, 2).integers(2**63) == settings.rng(1, 2).integers(2**63)
