"""What the torso senses is what physics does; what it commands is what moves."""

import mujoco
import numpy as np
import pytest
from rig import OTHER, SIDES, holding

from prospect_mj.robot import names, posture

HAND = 1.18 * 9.81
JAR = 0.40 * 9.81


def wrist_force(rig, side):
    """World frame."""
    turn = rig.data.site(names.wrist(side)).xmat.reshape(3, 3)
    return turn @ rig.torso.arms[side].read().wrist_force


@pytest.mark.parametrize("side", SIDES)
def test_an_empty_hand_weighs_what_it_weighs(rig, side):
    rig.present()
    assert wrist_force(rig, side) == pytest.approx([0, 0, HAND], abs=1e-3)


@pytest.mark.parametrize("side", SIDES)
def test_a_hand_with_the_jar_weighs_both(rig, side):
    rig.restore(holding(side))
    assert wrist_force(rig, side) == pytest.approx([0, 0, HAND + JAR], abs=0.01)


@pytest.mark.parametrize("side", SIDES)
def test_the_wrist_torque_is_that_of_the_weights_about_it(rig, side):
    """Sum of r x (m g) over hand and jar, taken up by the flange."""
    rig.restore(holding(side))
    data, model = rig.data, rig.model
    site = data.site(names.wrist(side))
    bodies = [
        i
        for i in range(model.nbody)
        if model.body(i).name.startswith((f"{side}_palm", f"{side}_finger", "jar/"))
    ]
    assert len(bodies) == 8
    up = np.array([0, 0, 9.81])
    arms = data.xipos[bodies] - site.xpos
    expected = np.cross(arms, model.body_mass[bodies, None] * up).sum(axis=0)
    torque = rig.torso.arms[side].read().wrist_torque
    assert np.linalg.norm(expected) > 0.5
    assert site.xmat.reshape(3, 3) @ torque == pytest.approx(expected, abs=2e-3)


def contact_of(rig, tip):
    """Force [N], place and normal into the object, from MuJoCo's own contact list."""
    geom = rig.model.geom(tip).id
    for i in range(rig.data.ncon):
        contact = rig.data.contact[i]
        if geom in contact.geom:
            force = np.zeros(6)
            mujoco.mj_contactForce(rig.model, rig.data, i, force)
            outward = 1 if contact.geom[0] == geom else -1
            return force[:3], contact.pos, outward * contact.frame[:3]
    raise AssertionError(f"{tip} touches nothing")


@pytest.mark.parametrize("side", SIDES)
def test_touch_agrees_with_the_contacts_of_the_simulator(rig, side):
    rig.restore(holding(side))
    touch = rig.torso.arms[side].read().touch
    assert touch.found.all()
    for i, tip in enumerate(names.fingertips(side)):
        force, place, normal = contact_of(rig, tip)
        assert touch.force[i] == pytest.approx(force[0], rel=1e-6)
        assert touch.force[i] > 0
        assert touch.shear[i] == pytest.approx(np.hypot(*force[1:]), rel=1e-6)
        assert touch.position[i] == pytest.approx(place, abs=1e-9)
        assert touch.normal[i] == pytest.approx(normal, abs=1e-9)


@pytest.mark.parametrize("side", SIDES)
def test_touch_normals_point_into_the_jar_from_a_fingertip(rig, side):
    """Sign: along the normal the jar's axis comes nearer; against it lies the tip."""
    rig.restore(holding(side))
    touch = rig.torso.arms[side].read().touch
    centre, axis = rig.simulation.jar_position, rig.simulation.jar_axis
    for i, tip in enumerate(names.fingertips(side)):
        inward = centre - touch.position[i]
        inward -= (inward @ axis) * axis
        inward /= np.linalg.norm(inward)
        assert touch.normal[i] @ inward > 0.99
        from_tip = touch.position[i] - rig.data.geom(tip).xpos
        assert touch.normal[i] @ from_tip == pytest.approx(0.0095, abs=1e-3)
        assert np.linalg.norm(touch.normal[i]) == pytest.approx(1.0)


@pytest.mark.parametrize("side", SIDES)
def test_the_grip_carries_the_jar_and_nothing_else(rig, side):
    """The tips' normal and friction forces on the jar sum up to its weight."""
    rig.restore(holding(side))
    total = np.zeros(3)
    for tip in names.fingertips(side):
        geom = rig.model.geom(tip).id
        for i in range(rig.data.ncon):
            contact = rig.data.contact[i]
            if geom in contact.geom:
                force = np.zeros(6)
                mujoco.mj_contactForce(rig.model, rig.data, i, force)
                onto_second = contact.frame.reshape(3, 3).T @ force[:3]
                total += onto_second if contact.geom[0] == geom else -onto_second
    assert total == pytest.approx([0, 0, JAR], abs=0.02)


@pytest.mark.parametrize("side", SIDES)
def test_empty_fingertips_feel_nothing(rig, side):
    rig.restore(holding(side))
    touch = rig.torso.arms[OTHER[side]].read().touch
    assert not touch.found.any()
    assert not touch.force.any()
    assert not touch.shear.any()


def test_a_reading_is_a_copy_that_later_physics_leaves_alone(rig):
    rig.present()
    reading = rig.torso.arms["left"].read()
    before = reading.joints.copy()
    rig.torso.arms["left"].command_joints(posture.presenting("left"))
    rig.wait(0.2)
    assert np.array_equal(reading.joints, before)
    assert np.abs(rig.joints("left") - before).max() > 0.01


@pytest.mark.parametrize("side", SIDES)
def test_encoders_tell_where_the_joints_are_and_not_where_they_should_be(rig, side):
    """In full motion, when the servos lag behind their commands."""
    rig.present()
    arm = rig.torso.arms[side]
    arm.command_joints(posture.presenting(side))
    arm.command_fingers(np.full(3, 1.3))
    rig.wait(0.1)
    own = arm.read()
    joints = [rig.data.joint(name) for name in names.arm_joints(side)]
    assert own.joints == pytest.approx([joint.qpos[0] for joint in joints])
    assert own.velocities == pytest.approx([joint.qvel[0] for joint in joints])
    fingers = [rig.data.joint(proximal) for proximal, _ in names.finger_joints(side)]
    assert own.fingers == pytest.approx([finger.qpos[0] for finger in fingers])
    assert own.joint_command == pytest.approx(posture.presenting(side))
    assert own.finger_command == pytest.approx(np.full(3, 1.3))
    assert np.abs(own.joints - own.joint_command).max() > 0.1
    assert np.abs(own.velocities).max() > 0.1


@pytest.mark.parametrize("side", SIDES)
def test_commands_reach_the_joints_of_their_side_only(rig, side):
    rig.present()
    rig.torso.arms[side].command_joints(posture.presenting(side))
    rig.wait(1.0)
    assert rig.joints(side) == pytest.approx(posture.presenting(side), abs=0.01)
    still = posture.home(OTHER[side])
    assert rig.joints(OTHER[side]) == pytest.approx(still, abs=1e-3)


@pytest.mark.parametrize("side", SIDES)
def test_one_motor_moves_both_links_of_a_finger_three_to_one(rig, side):
    """Closing freely the distal joint turns a third as far as the proximal one."""
    rig.present()
    motors = np.array([0.3, 0.8, 1.2])
    rig.torso.arms[side].command_fingers(motors)
    rig.wait(1.0)
    for angle, (proximal, distal) in zip(
        motors, names.finger_joints(side), strict=True
    ):
        assert rig.data.joint(proximal).qpos[0] == pytest.approx(angle, abs=0.01)
        assert rig.data.joint(distal).qpos[0] == pytest.approx(angle / 3, abs=0.01)


def test_finger_commands_stay_in_the_motors_range(rig):
    rig.present()
    arm = rig.torso.arms["left"]
    arm.command_fingers(np.array([-1.0, 9.0, 1.0]))
    assert arm.read().finger_command == pytest.approx([0.0, np.deg2rad(140), 1.0])


def test_fingers_do_not_give_way_to_a_push(rig):
    """5 N at a fingertip: it bends by force x lever / stiffness, stays, comes back.

    A backdrivable hand would go on opening for as long as it is pushed.
    """
    rig.present()
    tip = rig.model.geom("left_finger3_tip").id
    body = rig.model.geom_bodyid[tip]
    start = rig.data.qpos.copy()
    knuckle = rig.data.joint("left_finger3_proximal")
    lever = rig.data.geom_xpos[tip] - knuckle.xanchor
    push = 5.0 * np.cross(lever, knuckle.xaxis) / np.linalg.norm(lever)
    torque = np.cross(lever, push) @ knuckle.xaxis
    assert abs(torque) == pytest.approx(5.0 * np.linalg.norm(lever))
    rig.data.xfrc_applied[body, :3] = push
    moment = np.cross(rig.data.geom_xpos[tip] - rig.data.xipos[body], push)
    rig.data.xfrc_applied[body, 3:] = moment
    rig.wait(0.5)
    address = rig.model.joint("left_finger3_proximal").qposadr[0]
    bent = rig.data.qpos[address] - start[address]
    assert bent == pytest.approx(torque / 25.0, rel=0.25)
    rig.wait(1.5)
    assert rig.data.qpos[address] - start[address] == pytest.approx(bent, abs=5e-4)
    rig.data.xfrc_applied[:] = 0
    rig.wait(0.5)
    assert rig.data.qpos[address] == pytest.approx(start[address], abs=1e-3)
