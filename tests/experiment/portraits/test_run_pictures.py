"""Pictures of a run, looked at as far as a test can."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from prospect_mj.agent import StateFeatureGenerator
from prospect_mj.agent.features import N_BINS
from prospect_mj.control.result import Status
from prospect_mj.errors import RecordingError
from prospect_mj.experiment.portraits import grasp_picture, histograms
from prospect_mj.experiment.portraits.decisive_bins import MadeUpMind
from prospect_mj.experiment.portraits.grasp_phases import GraspPhases
from prospect_mj.experiment.portraits.grasp_picture import _LOOKS, portraits
from prospect_mj.experiment.portraits.histograms import SeenHistograms
from prospect_mj.experiment.portraits.run_frame import name_of
from prospect_mj.experiment.portraits.start_value_picture import start_values
from prospect_mj.experiment.portraits.strategy_picture import _SHOWN, strategies
from prospect_mj.experiment.portraits.trial_strategies import TrialStrategies
from prospect_mj.experiment.portraits.value_tables import signed
from prospect_mj.experiment.portraits.weights_picture import weights
from prospect_mj.experiment.run.config import TrainConfig

WIDTH = 1200
BANK = {side: np.full((2, N_BINS), 1 + (side == "left")) for side in ("left", "right")}


def picture(png):
    return cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR_RGB)


def pixels(image, colour):
    rgb = [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
    return int((np.abs(image.astype(int) - rgb).max(axis=-1) <= 3).sum())


def test_areas_of_the_strategies_are_their_shares(view):
    run = view(TrainConfig(trials=400, seed=3))
    # Shares alone: above the strip of single trials.
    image = picture(strategies(run))[:400]
    areas = np.array([pixels(image, look.colour) for look in _SHOWN])
    found = TrialStrategies.of(run.trials, run.actions).strategy
    counted = np.bincount(found, minlength=4)
    np.testing.assert_allclose(areas / areas.sum(), counted / 400, atol=0.02)


@pytest.mark.parametrize("draw", [strategies, start_values])
def test_pictures_are_as_wide_as_text_and_the_same_each_time(draw, pretrained):
    png = draw(pretrained)
    assert png == draw(pretrained)
    assert picture(png).shape[1] == WIDTH


@pytest.mark.parametrize("draw", [strategies, start_values])
@pytest.mark.parametrize(
    "config",
    [
        TrainConfig(trials=1),
        TrainConfig(trials=3, pretrain=3),
    ],
)
def test_runs_of_few_trials_can_be_drawn(draw, view, config):
    assert picture(draw(view(config))).shape[1] == WIDTH


def test_weights_are_drawn_on_one_scale_symmetric_about_zero(pretrained):
    learner = pretrained.learner
    original = learner.weights.copy()
    try:
        learner.weights[:] = 0.0
        learner.weights[0, 0], learner.weights[3, 150] = 1.0, -1.0
        mind = MadeUpMind.of(learner, StateFeatureGenerator(), BANK)
        image = picture(weights(mind, "product", "by hand"))
        # The ends of the colour map, blue and red, and its white middle.
        assert pixels(image, "#053061") > 20
        assert pixels(image, "#67001f") > 20
        assert pixels(image, "#f6f7f7") > 0.1 * image.shape[0] * WIDTH
    finally:
        learner.weights[:] = original


def test_grasps_have_the_colour_of_their_end():
    times, residual = np.array([0.0, 0.02, 0.5]), np.array([0.3, 0.3, 0.01])
    ended = [Status.CONVERGED, Status.OUT_OF_TIME]
    grasps = [GraspPhases("lid", status, times, residual) for status in ended]
    untouched = GraspPhases("body", Status.LOST, np.empty(0), np.empty(0))
    drawn = [picture(portraits([grasp, untouched], "by hand")) for grasp in grasps]
    for image, status in zip(drawn, ended, strict=True):
        found = [pixels(image, _LOOKS[one][0]) > 100 for one in ended]
        assert found == [one is status for one in ended]


@pytest.mark.parametrize(("n_corrected", "told"), [(1, True), (2, False)])
def test_the_heading_says_when_most_grasps_balance_at_once(n_corrected, told):
    times = 0.02 * np.arange(3)
    at_once = [GraspPhases("lid", Status.CONVERGED, times, times)] * 2
    late = np.array([0.0, 0.02, 0.5])
    corrected = [GraspPhases("lid", Status.CONVERGED, late, late)] * n_corrected
    words = "2 of 3 grasps balance at the first probe: they end where they start"
    assert grasp_picture._at_once([*at_once, *corrected]) == [words] * told


def test_numbers_of_a_table_have_their_sign_and_zero_a_plus():
    assert [signed(v) for v in (1.5, -2.0, -0.001)] == ["+1.50", "\u22122.00", "+0.00"]


def test_names_of_runs_are_short_and_no_mathematics(pretrained):
    long = replace(pretrained, path=pretrained.path / "$a$" / ("b$c$" * 20))
    assert len(name_of(long).replace("\\", "")) < 45
    assert picture(strategies(long)).shape[1] == WIDTH


def test_histograms_of_the_run_come_first_and_else_recorded_ones():
    live = TrainConfig(trials=1)
    assert SeenHistograms.of(BANK, live).source == "the kept episodes"
    one_sided = {"left": BANK["left"], "right": BANK["right"][:0]}
    shipped = SeenHistograms.of(one_sided, live)
    assert shipped.source == "the shipped recording"
    assert {side: rows.shape for side, rows in shipped.counts.items()} == {
        "left": (50, N_BINS),
        "right": (50, N_BINS),
    }


def test_a_recording_that_is_gone_is_replaced_by_the_shipped_one(tmp_path):
    config = TrainConfig(1, physics="recorded", recording=str(tmp_path / "gone"))
    assert SeenHistograms.of({}, config).source == "the shipped recording"


def test_a_recording_without_an_orientation_is_named(monkeypatch):
    monkeypatch.setattr(histograms, "_recorded", lambda _: {"left": BANK["left"]})
    with pytest.raises(RecordingError, match="both orientations"):
        SeenHistograms.of({}, TrainConfig(1))
