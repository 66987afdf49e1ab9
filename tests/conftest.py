"""Rendering in tests: the backend before MuJoCo, and loud news when there is none.

Interruptions, which tests send, are heard, and what is imported is no garbage.
"""

import functools
import gc
import os
import signal

# One of numpy's threads for each process: more would wait for each other, and use up
# the cores on which the other tests run. Read once, when numpy is imported.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from prospect_mj.sim import gl

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    # As of a shell's background job, which hands this on to every process.
    signal.signal(signal.SIGINT, signal.default_int_handler)

gc.disable()  # until all is collected: imports and thousands of tests, which stay

gl.configure()  # test modules import mujoco, which reads the choice once

import pytest  # noqa: E402

from prospect_mj.errors import RenderingUnavailable  # noqa: E402

NO_GL = "needs OpenGL"
NO_VULKAN = "needs Vulkan"


@functools.cache
def _why_no_gl() -> str | None:
    """The reason why nothing can be rendered here, or None."""
    try:
        gl.require_gl()
    except RenderingUnavailable as error:
        return str(error)
    return None


def pytest_collection_finish() -> None:
    """From now on look for garbage in what is new only."""
    gc.collect()
    gc.freeze()
    gc.enable()


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Skip a `gl` test without OpenGL; where CI=true it fails instead."""
    if item.get_closest_marker("gl") is None or (reason := _why_no_gl()) is None:
        return
    if os.environ.get("CI") == "true":
        pytest.fail(f"{NO_GL}, and CI must have it: {reason}", pytrace=False)
    pytest.skip(f"{NO_GL}: {reason}")


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Say in red how many tests went unrun for want of a driver, and the remedy."""
    skipped = terminalreporter.stats.get("skipped", [])
    reasons = [
        report.longrepr[2]
        for report in skipped
        if any(words in str(report.longrepr) for words in (NO_GL, NO_VULKAN))
    ]
    if reasons:
        terminalreporter.section("RENDERING WAS NOT TESTED", red=True, bold=True)
        terminalreporter.line(f"{len(reasons)} tests skipped: {reasons[0]}", red=True)
