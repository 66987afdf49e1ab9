"""What tests of both arms share."""

import pytest

from prospect_mj.robot import names


@pytest.fixture(scope="module", params=names.SIDES)
def side(request):
    return request.param
