"""Deep learners: there, or loudly missed."""

import os
from importlib.util import find_spec

import pytest

from prospect_mj.experiment.development.rivals.deep.agents import PACKAGES

NO_RIVALS = "needs the extra rivals, which `make agents` installs"


@pytest.fixture
def deep() -> None:
    """Skip without the libraries of deep learners; under `make agents` fail instead."""
    missing = [name for name in PACKAGES if find_spec(name) is None]
    if missing and os.environ.get("AGENTS") == "true":
        pytest.fail(f"{NO_RIVALS}: no {missing}", pytrace=False)
    if missing:
        pytest.skip(f"{NO_RIVALS}: no {missing}")
