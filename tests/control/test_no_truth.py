"""Controllers and actions know of the jar by sensors and belief, never by the truth.

A rule on their sources, shown to be able to fail, and an experiment: as long as the
robot has touched nothing, it does the same wherever the jar really is.
"""

import ast
from pathlib import Path

import numpy as np
import pytest
from rig import GRASP, SIDES

from prospect_mj.actions.belief import Belief, SeenJar
from prospect_mj.sim.placement import JarPlacement

PACKAGE = Path(__file__).resolve().parents[2] / "prospect_mj"
TRUTH = {
    "jar_position",
    "jar_axis",
    "contact",
    "ncon",
    "mj_contactForce",
    "mj_geomDistance",
    "cfrc_ext",
    "cfrc_int",
    "efc_force",
    "qfrc_constraint",
    "sensordata",
    "qpos",
    "qvel",
    "qacc",
    "xpos",
    "xquat",
    "xmat",
    "xipos",
    "geom_xpos",
    "site_xpos",
    "observer",
}
"""Attributes by which the simulator's state could be read."""


TWIN = "control/kinematics.py"
"""The owner of the kinematic twin, whose joint velocities it sets, but never reads."""


def readings_of_truth(text, path=""):
    """(line, name) of every mention of the simulator's truth."""
    tree = ast.parse(text)
    written = set(velocities_written(tree)) if path == TWIN else set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and node.attr in TRUTH:
            if node not in written:
                yield node.lineno, node.attr
        elif isinstance(node, ast.ImportFrom):
            for name in node.names:
                if name.name in TRUTH or name.name == "JAR":
                    yield node.lineno, name.name
        elif isinstance(node, ast.Constant) and node.value in TRUTH | {"jar/"}:
            yield node.lineno, node.value


def velocities_written(tree):
    """The `qvel` of every plain assignment `data.qvel[...] = ...`."""
    for node in ast.walk(tree):
        for target in node.targets if isinstance(node, ast.Assign) else []:
            if isinstance(target, ast.Subscript):
                owned = target.value
                if isinstance(owned, ast.Attribute) and owned.attr == "qvel":
                    yield owned


@pytest.mark.parametrize("folder", ["control", "actions", "supervisor", "vision"])
def test_no_truth_is_read(folder):
    files = sorted((PACKAGE / folder).rglob("*.py"))
    assert len(files) > 1
    found = {
        f"{file.relative_to(PACKAGE)}:{line}: {name}"
        for file in files
        for line, name in readings_of_truth(
            file.read_text("utf-8"), file.relative_to(PACKAGE).as_posix()
        )
    }
    assert not found


@pytest.mark.parametrize(
    "planted",
    [
        "def f(sim):\n    return sim.jar_position",
        "n = data.contact.geom",
        "from mujoco import mj_contactForce",
        "import mujoco\nmujoco.mj_contactForce(m, d, 0, f)",
        "x = data.body('jar/').xpos",
        "q = data.qpos[-7:]",
        "from prospect_mj.sim.scene import JAR",
        "getattr(data, 'qpos')",
        "simulation.observer = spy",
    ],
)
def test_the_rule_finds_a_planted_reading(planted):
    assert list(readings_of_truth(planted))


WRITING = "data.qvel[own] = speeds"


def test_the_twins_own_velocities_may_be_set_where_the_twin_is():
    assert not list(readings_of_truth(WRITING, TWIN))
    assert list(readings_of_truth(WRITING, "control/transit.py"))


@pytest.mark.parametrize(
    "planted",
    [
        "speeds = data.qvel[own]",
        "data.qvel[own] += 1.0",
        "data.qvel[own] = data.qvel[other]",
        "data.qpos[own] = 0.0",
        "data.qvel = speeds",
    ],
)
def test_but_no_more_than_set(planted):
    assert list(readings_of_truth(planted, TWIN))


def test_the_torso_has_no_view_of_the_jar(rig):
    """The joints, servos and sensors that an arm reads are its own."""
    rig.present()
    before = rig.torso.read()
    rig.data.qpos[-7:-4] += 0.3
    rig.data.qvel[-6:] = 1.0
    after = rig.torso.read()
    for side in SIDES:
        for field in ("joints", "velocities", "fingers", "wrist_force"):
            first, second = getattr(before[side], field), getattr(after[side], field)
            assert np.array_equal(first, second)
        assert np.array_equal(before[side].touch.found, after[side].touch.found)


@pytest.mark.parametrize("side", SIDES)
def test_until_it_touches_something_the_robot_does_the_same_wherever_the_jar_is(
    rig, side
):
    believed = SeenJar(rig.nominal.copy(), np.array([0.0, 1.0, 0.0]))
    commands = []
    for offset in ([0, 0, 0], [0.0, 0.0, -0.02], [0.02, 0.0, 0.0]):
        place = JarPlacement(rig.nominal + offset, 0.05, lid_left=True)
        rig.simulation.reset(place)
        rig.runner.begin(Belief(believed))
        untouched, log = [True], []

        def record(data, untouched=untouched, log=log):
            touch = [rig.torso.arms[each].read().touch.found.any() for each in SIDES]
            untouched[0] = untouched[0] and not any(touch)
            if untouched[0]:
                log.append(data.ctrl.copy())

        rig.simulation.observer = record
        try:
            rig.act(GRASP[side])
        finally:
            rig.simulation.observer = None
        commands.append(np.array(log))
    shortest = min(map(len, commands))
    assert shortest * rig.simulation.timestep > 1.5
    for log in commands[1:]:
        assert np.allclose(log[:shortest], commands[0][:shortest], atol=1e-9)
