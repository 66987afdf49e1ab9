"""Residual and rate of grasps, out of episodes made by hand and of real ones."""

from types import SimpleNamespace

import numpy as np
import pytest

from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.grasp_settings import GraspResult, GraspSettings
from prospect_mj.control.result import Status
from prospect_mj.episodes.episode import QUANTITIES, ControllerSpan, Signals
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.portraits import misled_grasps
from prospect_mj.experiment.portraits.grasp_phases import grasps_of
from prospect_mj.experiment.portraits.misled_grasps import MisledSettings, grasp_misled
from prospect_mj.experiment.run.config import TrainConfig

NAN = np.nan
RESIDUAL = QUANTITIES.index("residual")


def episode(left, right, spans, lid="left"):
    """An episode in which both hands' residuals are as given, a value per period."""
    times = CONTROL_PERIOD * np.arange(len(left))
    measured = np.full((len(left), 2, len(QUANTITIES)), NAN, np.float32)
    measured[:, 0, RESIDUAL], measured[:, 1, RESIDUAL] = left, right
    return SimpleNamespace(
        presentation=SimpleNamespace(orientation=lid),
        signals=Signals(times, measured),
        actions=[SimpleNamespace(controllers=spans)],
    )


def span(side, first, n, status=Status.CONVERGED, name="GraspController"):
    start = CONTROL_PERIOD * first
    return ControllerSpan(name, side, start, start + CONTROL_PERIOD * n, status, "")


def test_the_rate_is_the_change_over_the_time_that_passed():
    left = [NAN, 0.5, 0.6, NAN, NAN, NAN, 0.2, 0.2]
    told = episode(left, [NAN] * 8, [span("left", 0, 8)])
    (grasp,) = grasps_of(told)
    expected = [(0.6, 0.1 / 0.02), (0.2, -0.4 / 0.08), (0.2, 0.0)]
    np.testing.assert_allclose(grasp.phases, expected, rtol=1e-5, atol=1e-7)
    assert grasp.probes == 2


def test_each_grasp_has_its_own_hand_and_time():
    left, right = [0.1, 0.2, 0.3, 0.4], [0.5, 0.6, 0.7, 0.8]
    spans = [
        span("left", 0, 2),
        span("right", 1, 3, Status.STALLED),
        span("left", 2, 2, name="FineMotion"),
    ]
    first, second = grasps_of(episode(left, right, spans, lid="right"))
    np.testing.assert_allclose(first.residual, [0.1, 0.2], rtol=1e-6)
    np.testing.assert_allclose(second.residual, [0.6, 0.7, 0.8], rtol=1e-6)
    assert (first.end, first.status) == ("body", Status.CONVERGED)
    assert (second.end, second.status) == ("lid", Status.STALLED)


@pytest.mark.parametrize("residual", [[NAN, NAN], [NAN, 0.3]])
def test_without_two_measurements_there_is_no_phase(residual):
    told = episode(residual, [NAN] * 2, [span("left", 0, 2, Status.LOST)])
    (grasp,) = grasps_of(told)
    assert grasp.phases.shape == (0, 2)
    assert grasp.probes == np.isfinite(residual).sum()


@pytest.mark.gl
def test_phases_are_what_the_controller_measured(grasped):
    outcome, episode = grasped
    (grasp,) = grasps_of(episode)
    (result,) = (r.result for r in outcome.runs if isinstance(r.result, GraspResult))
    _, residual = np.transpose(result.trajectory)
    np.testing.assert_allclose(grasp.residual, residual, rtol=1e-6)
    eps, rate = grasp.phases[-1]
    assert eps == pytest.approx(result.residual, rel=1e-6)
    assert rate == pytest.approx(result.residual_rate, abs=1e-5)
    assert grasp.end == "lid"
    assert grasp.probes == result.probes


@pytest.mark.gl
def test_misled_hands_start_unbalanced_and_end_balanced():
    rng, accepted = np.random.default_rng(0), GraspSettings()
    grasps = list(grasp_misled(TrainConfig(trials=1), 4, rng))
    assert [grasp.end for grasp in grasps] == ["lid", "body", "body", "lid"]
    converged = [grasp for grasp in grasps if grasp.status is Status.CONVERGED]
    assert converged
    for grasp in converged:
        eps, rate = grasp.phases[-1]
        assert eps < accepted.residual_threshold
        assert abs(rate) < accepted.rate_threshold
    started = [grasp.residual[0] for grasp in grasps if grasp.residual.size]
    assert max(started) > 2 * accepted.residual_threshold


def test_an_error_is_across_the_axis_and_the_axis_stays_a_unit():
    axis = np.array([0.6, 0.8, 0.0])
    seen = misled_grasps.SeenJar(np.ones(3), axis)
    rng = np.random.default_rng(1)
    told = [misled_grasps._misplaced(seen, MisledSettings(), rng) for _ in range(400)]
    shifts = np.array([one.position for one in told]) - 1
    turns = np.array([one.axis for one in told])
    np.testing.assert_allclose(shifts @ axis, 0, atol=1e-15)
    np.testing.assert_allclose(np.linalg.norm(turns, axis=1), 1)
    assert shifts[:, 2].std() == pytest.approx(MisledSettings().position_sd, rel=0.15)
    assert turns[:, 2].std() == pytest.approx(MisledSettings().angle_sd, rel=0.15)


def test_errors_beyond_a_hands_reach_are_refused():
    with pytest.raises(InvalidValue, match="position"):
        MisledSettings(position_sd=0.1)
