"""Where a jar stops that does not fit, by numbers that were computed by hand."""

import pytest

from prospect_mj.recording.worlds import WORLDS
from prospect_mj.sim.props import Post, Well

BY_HAND = [
    # 45 mm in a square of 40 mm half width, on a slope of 45 degrees.
    (Well(), 0.045, 0.005),
    (Well(), 0.042, 0.002),
    (Well(), 0.048, 0.008),
    (Well(half_width=0.043), 0.045, 0.002),
    # The slope is 12 mm long and ends 12 / sqrt(2) mm above the rim.
    (Well(), 0.060, 0.0084853),
    (Well(chamfer=0.004), 0.048, 0.0028284),
    # On top of a post of 33 mm in a hole of 35 mm, however wide the jar is.
    (Well(depth=0.035, post=Post()), 0.045, -0.002),
    (Well(depth=0.035, post=Post()), 0.060, -0.002),
    (Well(depth=0.080, post=Post(height=0.070)), 0.045, -0.010),
]


@pytest.mark.parametrize(("well", "widest", "height"), BY_HAND)
def test_stop_height(well, widest, height):
    assert well.stop_height(widest) == pytest.approx(height, abs=1e-7)


def test_stop_heights_of_the_worlds():
    heights = {
        name: 1e3 * world.props.well.stop_height(world.props.jar.lid_radius)
        for name, world in WORLDS.items()
    }
    expected = dict.fromkeys(WORLDS, 5.0)
    expected |= {"post": -2.0, "wide-lid": 8.0, "narrow-lid": 2.0}
    assert heights == pytest.approx(expected)
