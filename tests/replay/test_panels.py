"""Curves are what was measured, and nothing is shown of what wasn't."""

from dataclasses import replace

import numpy as np
import pytest

from prospect_mj.control.grasp_settings import GraspSettings
from prospect_mj.episodes.episode import QUANTITIES, Signals
from prospect_mj.replay import blueprint, panels
from prospect_mj.replay.playback import model_of, play

pytestmark = pytest.mark.gl


@pytest.fixture(scope="module")
def played(late):
    return play(late, model_of(late))


def by_origin(late, played, q_values=None):
    return {panel.origin: panel for panel in panels.panels(late, played, q_values)}


def curve(panel, name):
    return next(curve for curve in panel.curves if curve.name == name)


def test_the_residual_of_a_hold_goes_on_from_that_of_the_grasp(late, played):
    panel = by_origin(late, played)[panels.RESIDUAL]
    probed, held = curve(panel, "right probe"), curve(panel, "right")
    there = ~np.isnan(probed.values)
    last = np.flatnonzero(there)[-1]
    at = np.searchsorted(held.times, probed.times[last])
    assert held.values[at] == pytest.approx(probed.values[last], rel=0.2)
    assert np.nanmax(held.values) < 2 * GraspSettings().residual_threshold
    # The right hand holds the jar from its grasp until the left one has it.
    holding = held.times[~np.isnan(held.values)]
    begins = late.actions[0].start - late.states.times[0]
    ends = late.actions[2].end - late.states.times[0]
    assert begins < holding[0] < holding[-1] < ends


def test_angles_are_in_degrees(late, played):
    panel = by_origin(late, played)[panels.IK_ANGLE]
    measured = late.signals.measured[:, 1, QUANTITIES.index("angle_error")]
    drawn = curve(panel, "right").values
    np.testing.assert_allclose(drawn, np.degrees(measured.astype(float)))


def test_panels_of_nothing_are_left_out(late, played):
    everything = by_origin(late, played, np.zeros((4, 6)))
    assert set(everything) == {
        *(panels.IK_POSITION, panels.IK_ANGLE, panels.WAY_LEFT, panels.JOINT_ERROR),
        *(panels.RESIDUAL, panels.FINGERTIPS, panels.WRIST, panels.INSERTION),
        panels.Q_VALUES,
    }
    nothing = np.full_like(late.signals.measured, np.nan)
    silent = replace(late, signals=Signals(late.signals.times, nothing))
    left = by_origin(silent, played)
    assert set(left) == {panels.RESIDUAL, panels.FINGERTIPS, panels.WRIST}
    # The layout is made of what there is.
    assert blueprint.blueprint("silent", tuple(left.values()), 10.0)
