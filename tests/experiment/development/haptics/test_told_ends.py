"""How often the end is told right, on grasps made by hand."""

from dataclasses import replace

import numpy as np
import pytest
from felt_by_hand import BODY_FEELS, felt, grasps

from prospect_mj.errors import RecordingError
from prospect_mj.experiment.development.haptics import ends
from prospect_mj.experiment.development.haptics.grasp import (
    BODY,
    CRADLE,
    HAND_OVER,
    LID,
    Grasp,
    of_table,
    table,
)
from prospect_mj.haptics import ClusterSettings

TWO = ClusterSettings(models=2, starts=3)


def told(made: list[Grasp], seed: int = 0) -> dict[tuple[str, str], float]:
    rows = ends.told("jar", made, TWO, np.random.default_rng(seed)).to_pylist()
    return {(row["by"], row["kind"]): row["told"] for row in rows}


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(4)


def test_ends_that_feel_unlike_are_told_by_the_category_and_not_by_two_bits(rng):
    shares = told(grasps(12, rng))
    for kind in (CRADLE, HAND_OVER):
        assert shares[ends.CATEGORY, kind] == shares[ends.FIRST_TOUCH, kind] == 1.0
        assert shares[ends.BITS, kind] == 0.5


def test_ends_that_feel_alike_are_told_by_chance(rng):
    shares = told(grasps(60, rng, lid=BODY_FEELS))
    for kind in (CRADLE, HAND_OVER):
        assert abs(shares[ends.CATEGORY, kind] - 0.5) < 0.15
        # The closing time is as different as ever: it is another sense.
        assert shares[ends.TIME, kind] == 1.0


def test_what_is_learned_is_not_tried_on_the_same_grasps(rng):
    """One presentation feels as no other does: it can be told only if it was learned.

    Both its ends are then taken for that which feels most like them, the lid.
    """
    made = [
        grasp._replace(felt=felt(0.030 if grasp.end == LID else 0.040))
        if grasp.presentation == 0
        else grasp
        for grasp in grasps(6, rng)
    ]
    four = ClusterSettings(models=4, starts=10)
    rows = ends.told("jar", made, four, np.random.default_rng(0)).to_pylist()
    shares = [row["told"] for row in rows if row["by"] == ends.CATEGORY]
    assert shares == pytest.approx([1 - 1 / 12] * 2)


def test_intervals_are_of_as_many_grasps_as_presentations(rng):
    rows = ends.told("jar", grasps(6, rng), TWO, rng).to_pylist()
    row = next(r for r in rows if r["by"] == ends.CATEGORY and r["kind"] == CRADLE)
    assert (row["grasps"], row["presentations"]) == (24, 12)
    assert (row["told"], row["high"]) == (1.0, 1.0)
    # (1 + z^2 / 12)^-1 with z = 1.96 (Wilson 1927, all of 12).
    assert row["low"] == pytest.approx(1 / (1 + 1.959964**2 / 12), abs=1e-6)


def test_two_models_are_better_than_one_where_there_are_two_kinds(rng):
    made = grasps(6, rng)
    fits = {n: ends.clustered(made, replace(TWO, models=n), rng) for n in (1, 2)}
    found = ends.numbers("jar", made, fits, TWO, rng).to_pylist()
    assert [row["models"] for row in found] == [1, 2]
    assert [row["bic"] for row in found] == [one.bic for one in fits.values()]
    assert found[1]["bic"] < found[0]["bic"]
    assert (found[0]["told"], found[1]["told"]) == (0.5, 1.0)


def test_a_number_of_models_with_too_few_grasps_is_left_out(rng):
    made = grasps(2, rng)
    fits = dict.fromkeys((4, 5), ends.clustered(made, TWO, rng))
    found = ends.numbers("jar", made, fits, TWO, rng).to_pylist()
    # Sixteen grasps, four for each model at least.
    assert [row["models"] for row in found] == [4]


def test_a_jar_of_which_one_end_was_never_held_is_told_of(rng):
    body = [grasp for grasp in grasps(6, rng) if grasp.end == BODY]
    with pytest.raises(RecordingError, match="one of the ends was never held"):
        ends.told("jar", body, TWO, rng)


def test_grasps_come_back_from_their_table(rng):
    made = grasps(2, rng)
    back = of_table(table(made))
    assert [g[:4] for g in back] == [g[:4] for g in made]
    for one, other in zip(back, made, strict=True):
        np.testing.assert_array_equal(one.felt, other.felt)
