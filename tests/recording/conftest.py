import pytest
from ideal_grower import grow_ideally


@pytest.fixture
def ideal(monkeypatch):
    """No physics; counts the actions that are run."""
    return grow_ideally(monkeypatch)
