"""The category of the grasp in each node of recorded trees, made by hand."""

import numpy as np
import pytest
from felt_by_hand import recording

from prospect_mj.errors import RecordingError
from prospect_mj.experiment.development.haptics import recorded, touch
from prospect_mj.experiment.development.haptics.grasp import (
    BODY,
    CRADLE,
    HAND_OVER,
    LID,
)
from prospect_mj.haptics import TrajectoryModels
from prospect_mj.recording import felt

MODELS = TrajectoryModels(
    weight=(0.5, 0.5),
    mean=(((0.006, 0.0),) * 2, ((0.013, 0.0),) * 2),
    deviation=(((0.001, 0.01),) * 2,) * 2,
)


def test_a_grasp_holds_until_the_next_one_that_succeeds():
    held = felt.holding_since(recording().nodes)
    tree = np.array([-1, 1, 2, 1, 4, 1, 6, -1])
    expected = np.concatenate([tree, np.where(tree < 0, -1, tree + 8)])
    np.testing.assert_array_equal(held, expected)


def test_each_node_has_the_category_of_its_grasp():
    """Lid left: the left hand has the lid, model 1, the right hand the body."""
    left = [0, 1, 0, 1, 0, 1, 1, 0]
    right = [0, 0, 1, 0, 1, 0, 0, 0]
    found = felt.category_of_nodes(recording(), MODELS)
    np.testing.assert_array_equal(found, left + right)


def test_the_very_end_is_told_where_a_hand_holds():
    found = touch.ends_of_nodes(recording())
    left = [BODY, LID, BODY, LID, BODY, LID, LID, BODY]
    np.testing.assert_array_equal(found[:8], left)
    holds = recording().nodes.holding[8:] > 0
    np.testing.assert_array_equal(found[8:][holds], 1 - np.array(left)[holds])


def test_first_grasps_and_the_hand_overs_after_them_are_drawn():
    found = recorded.grasps(recording())
    drawn = [(g.orientation, g.hand, g.kind, g.end) for g in found]
    left = [
        ("left", "left", CRADLE, LID),
        ("left", "right", CRADLE, BODY),
        ("left", "right", HAND_OVER, BODY),
    ]
    assert drawn[:3] == left
    assert drawn[3:] == [("right", hand, kind, 1 - end) for _, hand, kind, end in left]


def test_padding_is_no_part_of_a_grasp():
    outcomes = recording()
    nodes = outcomes.nodes
    padding = np.full((len(nodes.felt), 2, 2), np.nan, np.float32)
    nodes.felt = np.concatenate([nodes.felt, padding], axis=1)
    assert {len(grasp.felt) for grasp in recorded.grasps(outcomes)} == {3}


def test_a_recording_in_which_nothing_was_felt_is_told_in_one_line():
    outcomes = recording()
    outcomes.nodes.felt = np.full((16, 0, 2), np.nan, np.float32)
    with pytest.raises(RecordingError, match="no grasp of which it kept what was felt"):
        recorded.grasps(outcomes)
    assert not felt.category_of_nodes(outcomes, MODELS).any()
