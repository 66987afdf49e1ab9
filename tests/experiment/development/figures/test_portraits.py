"""Phase portraits show the models that the grasps drawn are of, and no others."""

import felt_by_hand
import numpy as np
import pytest

from prospect_mj.experiment.development.figures import portraits
from prospect_mj.haptics import TrajectoryModels

BODY, LID, FAR = (felt_by_hand.BODY_FEELS, felt_by_hand.LID_FEELS, 0.1)
ROUND = ((0.001, 0.01),) * 2


@pytest.fixture
def drawn(monkeypatch):
    """Numbers and stages of the models, by the title of the panel."""
    found = {}
    draw = portraits._draw_model

    def record(axes, models, number, stage):
        found.setdefault(id(axes), []).append((number, stage))
        draw(axes, models, number, stage)

    monkeypatch.setattr(portraits, "_draw_model", record)
    return found


def models():
    """One like grasps at the body, one like those at the lid, one like none."""
    mean = tuple(((one, 0.0), (one + 0.002, 0.0)) for one in (BODY, LID, FAR))
    return TrajectoryModels((0.4, 0.4, 0.2), mean, (ROUND,) * 3)


def test_models_that_no_grasp_is_of_are_not_drawn(drawn):
    grasps = felt_by_hand.grasps(4, np.random.default_rng(0))
    portraits.portraits({"standard": grasps}, {"standard": models()})
    assert list(drawn.values()) == [[(0, 0), (1, 0)]] * 2


def test_later_probes_are_drawn_only_where_a_hand_corrected_itself(drawn):
    # A hand that opens and closes again is at its second probe.
    again = felt_by_hand.felt(LID + 0.002, later=1.0)
    grasps = [
        one._replace(felt=np.concatenate([one.felt, again])) if one.end else one
        for one in felt_by_hand.grasps(4, np.random.default_rng(0))
    ]
    portraits.portraits({"standard": grasps}, {"standard": models()})
    assert list(drawn.values()) == [[(0, 0), (1, 0), (1, 1)]] * 2
