"""What is felt of jars and told by it, on grasps made by hand."""

from pathlib import Path

import numpy as np
import pytest
from felt_by_hand import grasps, recording

from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.development.haptics import ends, haptics
from prospect_mj.experiment.development.haptics.settings import HapticSettings
from prospect_mj.experiment.development.haptics.touch import BITS, CATEGORY, END, worlds
from prospect_mj.haptics import ClusterSettings, TrajectoryModels
from prospect_mj.recording.worlds import STANDARD


@pytest.fixture
def results(tmp_path: Path, monkeypatch) -> haptics.HapticResults:
    made = grasps(6, np.random.default_rng(0))
    monkeypatch.setattr(haptics, "grasps", lambda recorded: made)
    settings = HapticSettings(
        ClusterSettings(models=3, starts=2), most_models=2, grasped=0
    )
    felt = {STANDARD: recording()}
    return haptics.run(tmp_path, felt, settings, tell=lambda line: None)


def test_models_are_kept_beside_the_grasps(results, tmp_path: Path):
    path = tmp_path / haptics.FOLDER / haptics.models_file(STANDARD)
    assert TrajectoryModels.read(path) == results.models[haptics.recorded(STANDARD)]


def test_the_table_has_every_grasp_with_its_jar(results):
    (felt,) = results.grasps.values()
    found = results.tables["haptics_grasps"]
    assert found["jar"].to_pylist() == ["standard, recorded"] * len(felt)
    assert found["seconds"].to_pylist() == [g.felt[:, 0].tolist() for g in felt]


def test_the_end_is_told_by_each_sense_and_number_of_models(results):
    told = {row["by"]: row["told"] for row in results.told.to_pylist()}
    assert told == dict(zip(ends.BY, (0.5, 1.0, 1.0, 1.0), strict=True))
    by_number = [(r["models"], r["told"]) for r in results.numbers.to_pylist()]
    assert by_number == [(1, 0.5), (2, 1.0)]


def test_learners_are_told_the_hand_the_category_or_the_end(results):
    found = worlds(recording(), results.models[haptics.recorded(STANDARD)])
    numbers = {name: world.categories for name, world in found.items()}
    assert numbers == {BITS: 0, CATEGORY: 3, END: 2}


@pytest.mark.parametrize("grasped", [4, 10, -4, True])
def test_grasps_that_make_no_study_are_refused(grasped):
    with pytest.raises(InvalidValue, match="grasped"):
        HapticSettings(grasped=grasped)
