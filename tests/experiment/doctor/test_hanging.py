"""What hangs is ended, and takes nothing else of the examination with it."""

import sys

import pytest

from prospect_mj.experiment.doctor import rendering
from prospect_mj.experiment.doctor.check import Level


@pytest.fixture(autouse=True)
def impatient(monkeypatch):
    monkeypatch.setattr(rendering, "_PATIENCE", 0.0)


def test_a_probe_that_hangs_is_a_failure():
    (found,) = rendering.look_at_rendering()
    assert (found.name, found.level) == ("OpenGL", Level.FAIL)
    assert "within 0 s" in found.found


@pytest.mark.skipif(sys.platform != "linux", reason="others bring a driver along")
def test_a_viewer_that_hangs_leaves_the_others_their_lines():
    display, *hanging = rendering.look_at_display()
    assert display.name == "display"
    assert [check.name for check in hanging] == ["Rerun's viewer", "Vulkan"]
    for check in hanging:
        assert check.level is Level.WARN
        assert "within 0 s" in check.found
