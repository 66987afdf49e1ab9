"""What is felt of jars and told by it, on grasps made by hand."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from felt_by_hand import grasps, recording

from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.development.haptics import ends, haptics
from prospect_mj.experiment.development.haptics.grasp import Grasp
from prospect_mj.experiment.development.haptics.settings import HapticSettings
from prospect_mj.experiment.development.haptics.touch import BITS, CATEGORY, END, worlds
from prospect_mj.haptics import ClusterSettings, TrajectoryModels
from prospect_mj.recording.worlds import STANDARD

SETTINGS = HapticSettings(
    ClusterSettings(models=3, starts=2), starts=2, most_models=2, grasped=0
)


def studied(folder: Path, *worlds: str, **changed) -> haptics.HapticResults:
    felt = dict.fromkeys(worlds, recording())
    settings = replace(SETTINGS, **changed)
    return haptics.run(folder, felt, settings, tell=lambda line: None)


@pytest.fixture
def felt_by_hand(monkeypatch) -> list[Grasp]:
    made = grasps(6, np.random.default_rng(0))
    monkeypatch.setattr(haptics, "grasps", lambda recorded: made)
    return made


@pytest.fixture
def results(tmp_path: Path, felt_by_hand) -> haptics.HapticResults:
    return studied(tmp_path, STANDARD)


def test_models_are_kept_beside_the_grasps(results, tmp_path: Path):
    path = tmp_path / haptics.FOLDER / haptics.models_file(STANDARD)
    assert TrajectoryModels.read(path) == results.models[STANDARD]


def test_the_table_has_every_grasp_with_its_jar(results):
    (felt,) = results.grasps.values()
    found = results.tables["haptics_grasps"]
    assert found["jar"].to_pylist() == [STANDARD] * len(felt)
    assert found["seconds"].to_pylist() == [g.felt[:, 0].tolist() for g in felt]


def test_the_end_is_told_by_each_sense_and_number_of_models(results):
    told = {row["by"]: row["told"] for row in results.told.to_pylist()}
    assert told == dict(zip(ends.BY, (0.5, 1.0, 1.0, 1.0), strict=True))
    by_number = [(r["models"], r["told"]) for r in results.numbers.to_pylist()]
    assert by_number == [(1, 0.5), (2, 1.0), (3, 1.0)]


def test_other_numbers_of_models_are_there_for_learners(results):
    (others,) = results.others.values()
    assert {number: len(models) for number, models in others.items()} == {2: 2}
    assert len(results.models[STANDARD]) == 3


def test_learners_are_told_the_hand_the_category_or_the_end(results):
    found = worlds(recording(), results.models[STANDARD])
    numbers = {name: world.categories for name, world in found.items()}
    assert numbers == {BITS: 0, CATEGORY: 3, END: 2}


def test_what_comes_of_a_jar_hangs_on_no_other_jar(tmp_path, felt_by_hand):
    alone = studied(tmp_path, "wide-lid")
    beside = studied(tmp_path, STANDARD, "wide-lid")
    for made in ("models", "others"):
        assert getattr(beside, made)["wide-lid"] == getattr(alone, made)["wide-lid"]
    for name in ("told", "numbers"):
        rows = getattr(beside, name).to_pylist()
        own = [row for row in rows if row["jar"] == "wide-lid"]
        assert own == getattr(alone, name).to_pylist()


def test_jars_and_seeds_have_draws_of_their_own():
    other = replace(SETTINGS, seed=1)
    made = SETTINGS.rng(STANDARD), SETTINGS.rng("wide-lid"), other.rng(STANDARD)
    assert len({rng.random() for rng in made}) == 3
    assert SETTINGS.rng(STANDARD).random() == SETTINGS.rng(STANDARD).random()


def test_only_jars_without_a_recording_are_grasped_live(
    tmp_path, felt_by_hand, monkeypatch
):
    asked = []

    def grasped(folder, jars, *_):
        folder.mkdir()
        asked.append((folder, jars))
        return dict.fromkeys(jars, felt_by_hand)

    monkeypatch.setattr(haptics.live, "grasps", grasped)
    found = studied(tmp_path, STANDARD, "wide-lid", grasped=8)
    assert asked == [(tmp_path / haptics.FOLDER, ["narrow-lid"])]
    assert list(found.grasps) == [STANDARD, "wide-lid", "narrow-lid"]
    written = {path.name for path in (tmp_path / haptics.FOLDER).iterdir()}
    assert written == {"models_standard.json", "models_wide-lid.json"}


@pytest.mark.parametrize("grasped", [4, 10, -4, True])
def test_grasps_that_make_no_study_are_refused(grasped):
    with pytest.raises(InvalidValue, match="grasped"):
        HapticSettings(grasped=grasped)
