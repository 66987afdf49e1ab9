"""The arm's own harmonic function, as planning solves it, looked at cell by cell."""

import numpy as np
import pytest
from arm_scene import ArmScene

from prospect_mj.planning import search
from prospect_mj.planning.goals import GoalSet
from prospect_mj.planning.harmonic_field import harmonic_field
from prospect_mj.planning.planner import GrossPlanner, World
from prospect_mj.planning.streamline import streamline
from prospect_mj.robot import names, posture

LONGEST = 60.0
"""[rad]"""


@pytest.fixture(scope="module", params=names.SIDES)
def plan(request):
    """From home to over the receptacle, where the post stands beside."""
    scene = ArmScene()
    scene.place_post((0.55, -0.25 * names.sign(request.param)))
    planner = GrossPlanner(scene.model, request.param)
    goal = posture.over_well(request.param)[None]
    found = planner.plan(
        posture.home(request.param),
        [GoalSet(lambda: goal)],
        World(scene.data, scene.jars),
    )
    assert found.field is not None
    return found


def neighbours(values):
    """Values (2 n, ...) next to each cell; outside of the grid -inf."""
    padded = np.pad(values, 1, constant_values=-np.inf)
    inner = slice(1, -1)
    return np.array(
        [
            padded[
                tuple(
                    slice(1 + step, padded.shape[a] - 1 + step) if a == axis else inner
                    for a in range(values.ndim)
                )
            ]
            for axis in range(values.ndim)
            for step in (-1, 1)
        ]
    )


def test_the_maximum_principle_holds_in_every_cell(plan):
    field = plan.field
    goal = np.zeros(field.grid.shape, bool)
    goal[tuple(np.array(list(plan.goal_of)).T)] = True
    unknown = field.connected & ~goal
    assert unknown.sum() > 30_000
    around = neighbours(field.log_u)[:, unknown]
    own = field.log_u[unknown]
    assert (own < 0).all()
    assert (around.max(axis=0) > own).all()
    assert (around.min(axis=0) < own).all()


def test_a_streamline_from_any_connected_cell_reaches_the_goal(plan):
    """Every third of them: none is a maximum, as the principle above says of all."""
    field = plan.field
    cells = np.argwhere(field.connected)[::3]
    assert len(cells) > 10_000
    missed = [
        cell.tolist()
        for cell in cells
        if not streamline(field, field.grid.centre(cell), 0.05, LONGEST).reached
    ]
    assert not missed


def test_a_field_that_has_not_converged_shows_no_way(monkeypatch):
    side = "left"
    scene = ArmScene()

    def unfinished(*arguments):
        field = harmonic_field(*arguments)
        object.__setattr__(field, "converged", False)
        return field

    monkeypatch.setattr(search, "harmonic_field", unfinished)
    planner = GrossPlanner(scene.model, side)
    goal = GoalSet(lambda: posture.over_well(side)[None])
    world = World(scene.data, scene.jars)
    start = posture.home(side)
    # Finer grids, which are solved and refused in the same way, take seconds.
    assert planner.plan(start, [goal], world, thorough=False) is None
    monkeypatch.undo()
    assert planner.plan(start, [goal], world, thorough=False).field is not None
