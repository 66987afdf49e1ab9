import mujoco
import pytest

from prospect_mj import paths
from prospect_mj.errors import InvalidChoice
from prospect_mj.robot import names


def test_sides_are_opposites():
    assert names.other("left") == "right"
    assert names.other("right") == "left"
    assert (names.sign("left"), names.sign("right")) == (1, -1)


@pytest.mark.parametrize("function", [names.checked_side, names.other, names.sign])
@pytest.mark.parametrize("bad", ["", "Left", "middle"])
def test_no_other_side_is_known(function, bad):
    with pytest.raises(InvalidChoice, match=rf"{bad!r}; valid: left, right"):
        function(bad)


@pytest.mark.parametrize("side", names.SIDES)
def test_every_spelled_name_exists_in_the_torso(side):
    model = mujoco.MjModel.from_xml_path(str(paths.torso_xml()))
    for joint in names.arm_joints(side):
        assert model.joint(joint).id == model.actuator(joint).id
    for pair in names.finger_joints(side):
        for joint in pair:
            assert model.joint(joint).name == model.actuator(joint).name
    for body in (*names.arm_links(side), names.palm(side)):
        assert model.body(body).name == body
    for site in (names.wrist(side), names.grasp_site(side)):
        assert model.site(site).name == site
    sensors = (names.wrist_force(side), names.wrist_torque(side), *names.touches(side))
    for sensor in sensors:
        assert model.sensor(sensor).name == sensor
    for tip in names.fingertips(side):
        assert model.geom(tip).name == tip
    for eye in names.EYES:
        assert model.camera(eye).name == eye
    assert model.key(names.HOME).name == "home"
