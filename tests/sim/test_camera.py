import os
import subprocess
import sys

import mujoco
import numpy as np
import pytest

from prospect_mj.errors import InvalidChoice, InvalidValue, RenderingUnavailable
from prospect_mj.sim.camera import EyeSettings, StereoCamera
from prospect_mj.sim.pinhole import Pinhole

SCENE = """
<mujoco>
  <worldbody>
    <light pos="0 0 3"/>
    <camera name="left_eye" pos="0 .05 .8" xyaxes="0 -1 0 .8 0 .6" fovy="30"/>
    <camera name="right_eye" pos="0 -.05 .8" xyaxes="0 -1 0 .8 0 .6" fovy="30"/>
    <geom name="dot" type="sphere" size=".01" pos="{pos}" rgba="1 1 1 1"/>
    <body name="arm"><joint/><geom size=".01" pos="0 0 -1"/><camera name="hand"/></body>
  </worldbody>
</mujoco>
"""


def scene(pos="0.6 0 0"):
    model = mujoco.MjModel.from_xml_string(SCENE.format(pos=pos))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


def test_rays_undo_projection():
    model, _ = scene()
    eye = Pinhole.of_model(model, "left_eye", (320, 240))
    points = np.random.default_rng(0).uniform([0.4, -0.1, -0.1], [0.8, 0.1, 0.1])[None]
    ray = eye.rays(eye.project(points))[0]
    offset = points[0] - eye.position
    assert np.linalg.norm(np.cross(ray, offset)) < 1e-12
    homogeneous = eye.projection @ [*points[0], 1.0]
    assert eye.project(points)[0] == pytest.approx(homogeneous[:2] / homogeneous[2])


def test_a_camera_that_moves_has_no_calibration():
    model, _ = scene()
    with pytest.raises(InvalidValue, match="hand"):
        Pinhole.of_model(model, "hand", (320, 240))


def test_an_unknown_camera_is_refused_with_the_known_ones():
    model, _ = scene()
    with pytest.raises(InvalidChoice, match=r"third_eye.*left_eye, right_eye"):
        Pinhole.of_model(model, "third_eye", (320, 240))


@pytest.mark.parametrize("settings", [{"noise_sd": -1}, {"size": (9, 9)}])
def test_impossible_sensors_are_refused(settings):
    with pytest.raises(InvalidValue):
        EyeSettings(**settings)


@pytest.mark.gl
@pytest.mark.parametrize("pos", ["0.6 0 0", "0.55 0.1 0.05", "0.65 -0.1 -0.05"])
def test_the_renderer_agrees_with_the_pinhole_model(pos):
    """A small sphere appears where the calibration says, to a fraction of a pixel."""
    model, data = scene(pos)
    point = np.array([float(x) for x in pos.split()])[None]
    with StereoCamera(model, EyeSettings(noise_sd=0)) as camera:
        pair = camera.capture(data, np.random.default_rng(0))
        for image, eye in zip(pair, (camera.left, camera.right), strict=True):
            rows, columns = np.nonzero(image.max(axis=2) > 20)
            blob = np.array([columns.mean(), rows.mean()])
            assert blob == pytest.approx(eye.project(point)[0], abs=0.5)


@pytest.mark.gl
def test_noise_has_the_standard_deviation_asked_for_and_repeats_by_seed():
    model, data = scene()
    with StereoCamera(model, EyeSettings(noise_sd=0)) as camera:
        clean = camera.capture(data, np.random.default_rng(0)).left.astype(float)
    with StereoCamera(model, EyeSettings(noise_sd=4)) as camera:
        noisy = camera.capture(data, np.random.default_rng(5))
        again = camera.capture(data, np.random.default_rng(5))
        other = camera.capture(data, np.random.default_rng(6))
    grey = (clean > 20) & (clean < 235)
    assert grey.sum() > 100
    assert np.std((noisy.left - clean)[grey]) == pytest.approx(4, rel=0.2)
    assert np.array_equal(noisy.left, again.left)
    assert np.array_equal(noisy.right, again.right)
    assert not np.array_equal(noisy.left, other.left)
    assert noisy.left.shape == (240, 320, 3)
    assert noisy.left.dtype == np.uint8


@pytest.mark.gl
def test_closing_twice_is_fine_and_a_closed_camera_says_so():
    model, data = scene()
    camera = StereoCamera(model)
    camera.close()
    camera.close()
    with pytest.raises(RenderingUnavailable, match="closed"):
        camera.capture(data, np.random.default_rng(0))


@pytest.mark.gl
@pytest.mark.parametrize("last", [0, 1], ids=["the open one", "the closed one"])
def test_closing_a_camera_leaves_what_another_one_sees_as_it_was(last):
    """MuJoCo frees OpenGL's objects by number, which another context uses, too."""
    (model, data), rng = scene(), np.random.default_rng
    with StereoCamera(model) as camera, StereoCamera(model) as other:
        before = camera.capture(data, rng(0))
        (camera, other)[last].capture(data, rng(0))
        other.close()
        for was, now in zip(before, camera.capture(data, rng(0)), strict=True):
            np.testing.assert_array_equal(now, was)


@pytest.mark.gl
def test_a_camera_does_not_survive_a_fork():
    model, data = scene()
    with StereoCamera(model) as camera:
        child = os.fork()
        if child == 0:
            try:
                camera.capture(data, np.random.default_rng(0))
            except RenderingUnavailable:
                camera.close()
                os._exit(7)
            os._exit(1)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
        camera.capture(data, np.random.default_rng(0))


@pytest.mark.gl
def test_a_camera_that_nobody_closed_leaves_no_noise_at_exit():
    code = (
        "from prospect_mj.sim import gl; gl.configure()\n"
        "import mujoco, numpy as np\n"
        "from prospect_mj.sim.camera import StereoCamera\n"
        f"model = mujoco.MjModel.from_xml_string({SCENE.format(pos='0.6 0 0')!r})\n"
        "data = mujoco.MjData(model); mujoco.mj_forward(model, data)\n"
        "camera = StereoCamera(model)\n"
        "camera.capture(data, np.random.default_rng(0))\n"
    )
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert run.stderr == ""
