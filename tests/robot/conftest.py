import pytest
from rig import Rig, shared_rig


@pytest.fixture
def rig() -> Rig:
    return shared_rig()
