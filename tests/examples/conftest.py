"""The examples can be imported, and what they need is there or loudly missed."""

import os
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
NEEDED = ("stable_baselines3", "sb3_contrib", "moviepy")
NO_AGENTS = "needs the dependency group agents, which `make agents` installs"

sys.path.insert(0, str(EXAMPLES))


@pytest.fixture
def agents() -> None:
    """Skip without Stable-Baselines3 and its like; under `make agents` fail instead."""
    missing = [name for name in NEEDED if find_spec(name) is None]
    if not missing:
        return
    if os.environ.get("AGENTS") == "true":
        pytest.fail(f"{NO_AGENTS}: no {missing}", pytrace=False)
    pytest.skip(f"{NO_AGENTS}: no {missing}")


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Say in red that other agents went untested."""
    skipped = terminalreporter.stats.get("skipped", [])
    reasons = [r.longrepr[2] for r in skipped if NO_AGENTS in str(r.longrepr)]
    if reasons:
        title = "OTHER AGENTS WERE NOT TESTED"
        terminalreporter.section(title, red=True, bold=True)
        terminalreporter.line(f"{len(reasons)} tests skipped: {reasons[0]}", red=True)
