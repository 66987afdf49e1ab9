"""The doctor finds what was broken on purpose, and never dies of it."""

import json
import os
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import pytest

from prospect_mj import display, paths
from prospect_mj.cli import doctor
from prospect_mj.experiment.doctor import (
    examination,
    machine,
    packages,
    rendering,
    vulkan,
)
from prospect_mj.experiment.doctor import recorded as recordings
from prospect_mj.experiment.doctor.check import Check, Level, guarded
from prospect_mj.planning import kernel_cache
from prospect_mj.recording.provenance import PACKAGES
from prospect_mj.sim import gl

ROOT = Path(__file__).resolve().parents[2]


def only(checks, name):
    (found,) = [check for check in checks if check.name == name]
    return found


@pytest.fixture
def standard_alone(tmp_path, monkeypatch):
    """A folder of shipped recordings with that of the standard world."""
    folder = tmp_path / "recordings" / "standard"
    folder.parent.mkdir()
    folder.symlink_to(paths.RECORDINGS / "standard")
    monkeypatch.setattr(paths, "RECORDINGS", folder.parent)
    return folder


@pytest.fixture
def asked_for(monkeypatch):
    """Set what the installed distribution asks for."""

    def ask(*lines):
        monkeypatch.setattr(metadata, "requires", lambda name: list(lines))

    return ask


def test_every_package_that_decides_outcomes_has_a_line(asked_for):
    asked_for("mujoco<4,>=3.17", "tqdm>=4", "ray>=2; extra == 'cluster'")
    names = {check.name.lower() for check in packages.look_at_packages()}
    assert {name.lower() for name in PACKAGES} <= names
    assert "ray" not in names


def test_another_version_fails_and_says_what_to_install(asked_for):
    asked_for("mujoco<3", "tqdm>=4")
    found = only(packages.look_at_packages(), "mujoco")
    assert found.level is Level.FAIL
    assert metadata.version("mujoco") in found.found
    assert found.remedy == "pip install 'mujoco<3'"


def test_a_package_that_decides_nothing_is_told_of_when_it_is_wrong(asked_for):
    asked_for("tqdm>=4", "tyro>=1")
    assert only(packages.look_at_packages(), "other packages").found.startswith("2 ")
    asked_for("tqdm>=999", "tyro>=1", "no-such-package")
    checks = packages.look_at_packages()
    assert only(checks, "tqdm").level is Level.FAIL
    assert only(checks, "no-such-package").found == "not installed"
    assert only(checks, "other packages").found.startswith("1 ")


def test_a_checkout_that_is_not_installed_is_a_warning(monkeypatch):
    def missing(name):
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(metadata, "requires", missing)
    (found,) = packages.look_at_packages()
    assert found.level is Level.WARN
    assert "pip install --editable ." in found.remedy


def test_one_core_and_little_memory_warn(monkeypatch):
    monkeypatch.setattr(machine.joblib, "cpu_count", lambda: 1)
    assert machine.look_at_cores()[0].level is Level.WARN
    monkeypatch.setattr(machine, "ENOUGH_MEMORY", 1e6)
    (memory,) = machine.look_at_memory()
    assert memory.level is Level.WARN
    assert "--jobs 1" in memory.remedy


def test_places_that_can_not_be_written_to_warn(tmp_path, monkeypatch):
    (tmp_path / "file").touch()
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "file" / "below"))
    monkeypatch.chdir(tmp_path)
    cache, runs = machine.look_at_places()
    assert (cache.level, runs.level) == (Level.WARN, Level.OK)
    assert "NUMBA_CACHE_DIR" in cache.remedy
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


@pytest.mark.parametrize("chosen", [True, False])
def test_the_cache_is_the_one_that_is_used(chosen, tmp_path, monkeypatch):
    monkeypatch.delenv("NUMBA_CACHE_DIR", raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "home"))
    if chosen:
        monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "chosen"))
    monkeypatch.setattr(kernel_cache.numba.config, "CACHE_DIR", "")
    kernel_cache.use()
    assert Path(kernel_cache.numba.config.CACHE_DIR).parent == machine.cache_folder()


def test_a_recording_that_is_missing_fails(tmp_path, monkeypatch):
    monkeypatch.setattr(paths, "RECORDINGS", tmp_path)
    (found,) = recordings.look_at_recordings()
    assert found.level is Level.FAIL
    assert "recording.yaml" in found.found
    assert "prospect record --world standard" in found.remedy


def test_every_world_that_was_recorded_has_a_line(standard_alone):
    folder = standard_alone.parent / "post"
    folder.mkdir()
    (folder / "recording.yaml").write_bytes(b"damaged")
    standard, post = recordings.look_at_recordings()
    assert (standard.level, post.level) == (Level.OK, Level.FAIL)
    assert standard.found.startswith("standard: ")
    assert str(folder) in post.found
    assert "prospect record --world post" in post.remedy


def test_a_recording_in_another_worlds_place_fails(standard_alone):
    (standard_alone.parent / "post").symlink_to(standard_alone)
    _, post = recordings.look_at_recordings()
    assert post.level is Level.FAIL
    assert post.found.endswith("post is of the world standard")


def test_a_recording_of_other_packages_says_which_to_install(
    standard_alone, monkeypatch
):
    key = recordings.RecordingKey.read(standard_alone)
    present = recordings.RecordingKey(
        key.config, key.sha256, {**key.versions, "mujoco": "9.9"}, key.machine
    )
    monkeypatch.setattr(
        recordings.RecordingKey, "present", classmethod(lambda cls, config: present)
    )
    (found,) = recordings.look_at_recordings()
    assert found.level is Level.WARN
    assert found.remedy == f"pip install 'mujoco=={key.versions['mujoco']}'"


def test_a_recording_of_other_sources_is_to_be_made_anew(standard_alone, monkeypatch):
    key = recordings.RecordingKey.read(standard_alone)
    present = recordings.RecordingKey(
        key.config, {**key.sha256, "sources": "other"}, key.versions, key.machine
    )
    monkeypatch.setattr(
        recordings.RecordingKey, "present", classmethod(lambda cls, config: present)
    )
    (found,) = recordings.look_at_recordings()
    assert "sources changed since" in found.found
    assert "prospect record" in found.remedy


@pytest.mark.parametrize(
    ("backend", "remedy"),
    [
        ({"MUJOCO_GL": "osmesa"}, "unset MUJOCO_GL"),
        (
            {"MUJOCO_GL": "egl", "__EGL_VENDOR_LIBRARY_FILENAMES": os.devnull},
            f"apt-get install {' '.join(gl.DEBIAN_PACKAGES)}",
        ),
    ],
    ids=["osmesa", "no driver"],
)
@pytest.mark.skipif(sys.platform != "linux", reason="EGL is Linux's backend")
def test_without_opengl_it_says_what_to_type(backend, remedy, monkeypatch):
    for name, value in backend.items():
        monkeypatch.setenv(name, value)
    (found,) = rendering.look_at_rendering()
    assert (found.name, found.level) == ("OpenGL", Level.FAIL)
    assert backend["MUJOCO_GL"] in found.found
    assert found.remedy == remedy


@pytest.mark.gl
@pytest.mark.smoke
def test_with_opengl_it_measures(monkeypatch):
    monkeypatch.setattr(rendering, "SLOW", 0.0)
    opengl, look, action = rendering.look_at_rendering()
    assert gl.renderer_name() in opengl.found
    assert {opengl.level, look.level, action.level} == {Level.OK}
    assert 1 < float(look.found.split()[0]) < 10_000
    assert 1 < float(action.found.split()[0]) < 60_000
    monkeypatch.setattr(rendering, "SLOW", 1e6)
    told = {"look_ms": 40.0, "action_ms": 5400.0, "times_real_time": 1.0}
    assert rendering.speed(told)[1].level is Level.WARN


def test_a_probe_that_crashes_is_a_failure(monkeypatch):
    crashed = subprocess.CompletedProcess([], -11, "", "")
    monkeypatch.setattr(rendering, "_python", lambda *words: crashed)
    (found,) = rendering.look_at_rendering()
    assert found.level is Level.FAIL
    assert "-11" in found.found


def test_without_a_display_it_says_what_to_do_instead(monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    monkeypatch.setattr(display.sys, "platform", "linux")
    monkeypatch.setattr(rendering, "_vulkan", list)
    shown, viewer = rendering.look_at_display()
    assert shown.level is Level.WARN
    assert "--video" in shown.remedy
    assert viewer.level is Level.OK


@pytest.mark.skipif(sys.platform != "linux", reason="others bring a driver along")
@pytest.mark.parametrize("missing", ["driver", "library"])
def test_without_vulkan_it_says_what_to_install(missing, monkeypatch, capsys):
    if missing == "driver":
        for name in ("VK_DRIVER_FILES", "VK_ICD_FILENAMES"):
            monkeypatch.setenv(name, os.devnull)
    else:
        monkeypatch.setattr(vulkan, "_LOADER", "libnone.so")
        code = vulkan.main()
        done = subprocess.CompletedProcess([], code, "", capsys.readouterr().err)
        monkeypatch.setattr(rendering, "_python", lambda *_: done)
    (found,) = rendering._vulkan()
    assert found.level is Level.WARN
    assert found.found.startswith(("no graphics driver", "libnone.so: "))
    assert "mesa-vulkan-drivers" in found.remedy


def test_a_look_that_breaks_is_a_failure_and_no_more():
    def broken():
        yield Check("first", Level.OK, "well")
        raise AttributeError("no such\nthing")

    first, second = guarded("it", broken)
    assert first.found == "well"
    assert second.level is Level.FAIL
    assert "AttributeError: no such thing" in second.found


PLANTED = {
    "well": [Check("a", Level.OK, "fine")],
    "warns": [Check("a", Level.OK, "fine"), Check("b", Level.WARN, "meagre", "feed")],
    "fails": [Check("b", Level.FAIL, "broken", "mend it")],
}


@pytest.mark.parametrize(("name", "code"), [("well", 0), ("warns", 0), ("fails", 1)])
def test_the_exit_code_tells_whether_something_fails(name, code, monkeypatch, capsys):
    monkeypatch.setattr(examination, "LOOKS", {name: lambda: PLANTED[name]})
    assert doctor.main([]) == code
    words = capsys.readouterr().out
    assert "fine" in words or code
    assert ("-> mend it" in words) == bool(code)
    assert doctor.main(["--json"]) == code
    found = json.loads(capsys.readouterr().out)
    assert found["ok"] == (not code)
    assert [check["level"] for check in found["checks"]] == [
        str(check.level) for check in PLANTED[name]
    ]


def test_on_a_terminal_looks_are_counted(monkeypatch, capsys):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    monkeypatch.setattr(examination, "LOOKS", {"well": lambda: PLANTED["well"]})
    assert doctor.main([]) == 0
    bar = capsys.readouterr().err
    assert "look" in bar
    assert "it/s" not in bar


def test_it_runs_where_mujoco_can_not_be_loaded(tmp_path):
    """All that may break is in processes of its own."""
    (tmp_path / "mujoco.py").write_text("raise ImportError('libGL.so.1 is missing')")
    code = "from prospect_mj.cli.app import main; raise SystemExit(main(['doctor']))"
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": f"{tmp_path}{os.pathsep}{ROOT}"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 1
    assert done.stderr == ""
    (line,) = [line for line in done.stdout.splitlines() if line.startswith("FAIL")]
    assert "libGL.so.1 is missing" in line
