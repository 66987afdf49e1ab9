"""Rendering off-screen works here, and its absence is told in one useful line.

Each case needs a fresh process: MuJoCo reads the choice of a backend once.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from prospect_mj.sim import gl

ROOT = Path(__file__).resolve().parents[2]
NO_DRIVER = {"__EGL_VENDOR_LIBRARY_FILENAMES": os.devnull}
RENDER = """
import mujoco
model = mujoco.MjModel.from_xml_string('<mujoco><worldbody><light pos="0 0 3"/>'
    '<geom size="1 1 1" type="box" rgba="1 0 0 1"/></worldbody></mujoco>')
data = mujoco.MjData(model)
mujoco.mj_forward(model, data)
with mujoco.Renderer(model, 8, 8) as renderer:
    renderer.update_scene(data)
    red, green, blue = renderer.render()[4, 4]
assert red > 50 > green == blue, (red, green, blue)
"""

linux = pytest.mark.skipif(sys.platform != "linux", reason="EGL is Linux's backend")


def run(*arguments: str, cwd: Path | None = None, **environment: str):
    """Run Python in a process that inherits no choice of a backend."""
    inherited = {
        name: value
        for name, value in os.environ.items()
        if name not in {"CI", "PYOPENGL_PLATFORM"} and not name.startswith("MUJOCO_")
    }
    return subprocess.run(
        [sys.executable, *arguments],
        env=inherited | {"PYTHONPATH": str(ROOT)} | environment,
        cwd=cwd,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )


@linux
def test_unset_becomes_egl(monkeypatch):
    monkeypatch.setenv("MUJOCO_GL", "")
    gl.configure()
    assert os.environ["MUJOCO_GL"] == "egl"


@pytest.mark.parametrize("backend", ["osmesa", "glfw", "disabled"])
def test_explicit_choice_wins(monkeypatch, backend):
    monkeypatch.setenv("MUJOCO_GL", backend)
    gl.configure()
    assert os.environ["MUJOCO_GL"] == backend


@pytest.mark.gl
def test_renderer_has_a_name():
    assert gl.renderer_name().strip()


@pytest.mark.gl
@pytest.mark.parametrize(
    "before",
    [
        "",
        "import mujoco",
        "from dm_control import mjcf",
        "import mujoco, os; os.environ['MUJOCO_GL'] = 'egl'",
    ],
    ids=["first", "after mujoco", "after dm_control", "chosen after mujoco"],
)
def test_renders_whatever_was_imported_first(before):
    configure = "from prospect_mj.sim import gl; gl.configure()"
    done = run("-c", f"{before}\n{configure}\n{RENDER}", PYTHONWARNINGS="ignore")
    assert done.returncode == 0, done.stderr


@pytest.mark.gl
def test_check_prints_one_line():
    done = run("-m", "prospect_mj.cli.check_gl")
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("OpenGL: ")
    assert done.stdout.count("\n") == 1
    assert gl.renderer_name() in done.stdout


@linux
@pytest.mark.parametrize(
    "broken",
    [NO_DRIVER, {"MUJOCO_EGL_DEVICE_ID": "999"}, {"MUJOCO_GL": "no-such-backend"}],
    ids=["no driver", "no such device", "no such backend"],
)
def test_check_names_the_packages(broken):
    done = run("-m", "prospect_mj.cli.check_gl", **broken)
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.startswith("error: no OpenGL context with MUJOCO_GL=")
    assert done.stderr.count("\n") == 1
    assert " ".join(gl.DEBIAN_PACKAGES) in done.stderr


@linux
@pytest.mark.parametrize(
    ("environment", "exit_code", "said"),
    [
        ({}, 0, "RENDERING WAS NOT TESTED"),
        ({"CI": "true"}, 1, "CI must have it"),
    ],
    ids=["at home", "in CI"],
)
def test_marked_tests_without_gl(tmp_path, environment, exit_code, said):
    shutil.copy(ROOT / "tests" / "conftest.py", tmp_path)
    (tmp_path / "pytest.ini").write_text("[pytest]\nmarkers = gl: needs OpenGL\n")
    (tmp_path / "test_it.py").write_text(
        "import pytest\n@pytest.mark.gl\ndef test_picture(): pass\ndef test_sum(): pass"
    )
    done = run("-m", "pytest", cwd=tmp_path, **NO_DRIVER, **environment)
    assert done.returncode == exit_code, done.stdout
    assert said in done.stdout
    assert "1 passed" in done.stdout
    assert "libegl1" in done.stdout
