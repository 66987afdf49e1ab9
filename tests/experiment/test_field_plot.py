"""The picture of a harmonic function: what it shows is what the planner computes."""

import numpy as np
import pytest

from prospect_mj.experiment import corridor, field_plot, field_slice

pytestmark = pytest.mark.gl


@pytest.fixture(scope="module")
def shown():
    return field_slice.joint_slice()


def test_home_is_free_and_things_are_in_the_way(shown):
    from prospect_mj.robot import posture

    home = np.array(posture.home("left"))[list(field_slice.JOINTS)]
    assert shown.obstacle[tuple(shown.grid.cell_of(home))] == field_slice.FREE
    kinds = np.unique(shown.obstacle)
    assert {0, 1, 2, 3, 4} <= set(kinds.tolist())


def test_every_streamline_of_the_picture_arrives(shown):
    lines = shown.streamlines(field_plot.STARTS)
    assert len(lines) == len(field_plot.STARTS)
    assert all(line.reached for line in lines)


def test_the_corridor_decays_at_the_rate_of_its_difference_equation():
    """cosh(k) = 2 - cos(pi / w) with w cells from wall to wall."""
    widths, log_u = corridor.decay()
    width = corridor.CELLS_ACROSS + 1
    per_width = -width * np.arccosh(2 - np.cos(np.pi / width)) / np.log(10)
    far = (widths > 20) & (widths < 280)
    slope = np.polyfit(widths[far], log_u[far], 1)[0]
    assert slope == pytest.approx(per_width, rel=1e-6)
    assert log_u.min() < np.log10(np.finfo(float).smallest_subnormal)


def test_the_picture_is_drawn_twice_alike(shown):
    assert field_plot.field_picture() == field_plot.field_picture()
