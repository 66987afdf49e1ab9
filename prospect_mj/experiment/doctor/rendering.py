"""Whether images can be rendered, windows opened and episodes shown, and how fast."""

import json
import os
import subprocess
import sys
from typing import Any

from prospect_mj.display import why_no_window
from prospect_mj.experiment.doctor.check import Check, Level
from prospect_mj.experiment.doctor.packages import requirement_of
from prospect_mj.replay.viewer import VULKAN_PACKAGE
from prospect_mj.sim import gl

SLOW = 5.0
"""Simulated seconds per wall second below which a run of 1000 trials takes an hour."""
_PATIENCE = 300.0
"""For code that is compiled for the first time, on a slow machine [s]."""
_PROBE = "prospect_mj.experiment.doctor.probe"
_VULKAN = "prospect_mj.experiment.doctor.vulkan"


def look_at_rendering() -> list[Check]:
    """OpenGL, and the time that a look and an action take."""
    backend = os.environ.get("MUJOCO_GL") or "native"
    done = _python("-m", _PROBE)
    told: dict[str, Any] = {}
    for line in done.stdout.splitlines():
        told |= json.loads(line)
    reason = _last_line(done)
    if "renderer" not in told:
        return [Check("OpenGL", Level.FAIL, reason, _gl_remedy(backend))]
    opengl = Check("OpenGL", Level.OK, f"{backend}, {told['renderer']}")
    if "look_ms" not in told:
        remedy = "install prospect-mj again, or git restore models assets"
        return [opengl, Check("simulation", Level.FAIL, reason, remedy)]
    return [opengl, *speed(told)]


def look_at_display() -> list[Check]:
    """A window for `prospect view`, and Rerun's viewer with what it draws by."""
    return [_display(), _rerun(), *_vulkan()]


def speed(told: dict[str, Any]) -> list[Check]:
    """What the probe's measurements mean.

    Args:
        told: as `probe.speed` gives it.
    """
    look = Check("stereo look", Level.OK, f"{told['look_ms']:.0f} ms")
    ratio = told["times_real_time"]
    found = f"{told['action_ms']:.0f} ms, {ratio:.0f} simulated seconds per second"
    if ratio >= SLOW:
        return [look, Check("action", Level.OK, found)]
    remedy = "end other programs, or use --physics recorded, which simulates nothing"
    return [look, Check("action", Level.WARN, found, remedy)]


def _gl_remedy(backend: str) -> str:
    if backend not in ("egl", "native"):
        return "unset MUJOCO_GL"
    return f"apt-get install {' '.join(gl.DEBIAN_PACKAGES)}"


def _display() -> Check:
    reason = why_no_window()
    if reason is None:
        return Check("display", Level.OK, "a window opens")
    remedy = "prospect view --video FILE.mp4; prospect replay RUN --serve"
    return Check("display", Level.WARN, reason, remedy)


def _rerun() -> Check:
    done = _python("-m", "rerun_cli", "--version")
    if done.returncode == 0:
        version = " ".join(done.stdout.split()[:2])
        return Check("Rerun's viewer", Level.OK, version)
    wanted = requirement_of("rerun-sdk")
    remedy = f"pip install --force-reinstall '{wanted.name}{wanted.specifier}'"
    return Check("Rerun's viewer", Level.WARN, _last_line(done), remedy)


def _vulkan() -> list[Check]:
    """Drivers, which other systems than Linux bring along."""
    if sys.platform != "linux":
        return []
    done = _python("-m", _VULKAN)
    n_devices = int(done.stdout) if done.returncode == 0 else 0
    if n_devices:
        return [Check("Vulkan", Level.OK, f"devices to draw on: {n_devices}")]
    reason = "no graphics driver" if done.returncode == 0 else _last_line(done)
    remedy = f"apt-get install {VULKAN_PACKAGE}; replay with --save or --serve"
    return [Check("Vulkan", Level.WARN, reason, remedy)]


def _python(*arguments: str) -> subprocess.CompletedProcess[str]:
    """Run Python in a process of its own; one that hangs is ended, and has failed."""
    command = [sys.executable, *arguments]
    try:
        return subprocess.run(
            command, capture_output=True, text=True, timeout=_PATIENCE, check=False
        )
    except subprocess.TimeoutExpired:
        reason = f"nothing came of it within {_PATIENCE:.0f} s"
        return subprocess.CompletedProcess(command, 1, "", reason)


def _last_line(done: subprocess.CompletedProcess[str]) -> str:
    """Why a process failed, in its own words."""
    said = done.stderr.strip().splitlines()
    return said[-1] if said else f"its process ended with {done.returncode}"
