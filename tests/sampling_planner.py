"""A judge of its own for gross motion: RRT-Connect, collision-checked by MuJoCo.

Kuffner and LaValle, "RRT-Connect: an efficient approach to single-query path planning"
(ICRA 2000). It shares nothing with the planner that it judges, neither grid nor shapes.
"""

import copy
import functools
from collections.abc import Callable
from dataclasses import dataclass

import mujoco
import numpy as np

from prospect_mj.robot import names, posture, wam
from prospect_mj.robot.names import Side
from prospect_mj.sim.scene import SceneSettings, compile_twin, obstacle_mocap

_FIXED_LINKS = 2
"""Motor and shoulder stay where they are; they are in the way like the trunk."""
_NEIGHBOURS = ((0, 2), (4, 6))
"""Links with one joint's link between them, which come within 1 mm and 10 mm of each
other by construction: these may not touch, but need no clearance."""


class ArmIsFree:
    """Whether an arm keeps a clearance to everything, at given joint angles.

    Counted are distances of its moving links and its open hand to the trunk, head,
    fixtures, obstacle, the other arm and to its own links.

    Args:
        side: which arm.
        clearance: [m]
        scene: what stands around it; the other arm is at home.
    """

    def __init__(self, side: Side, clearance: float, scene: SceneSettings) -> None:
        """Copy the twin's model and let it collide only where this arm takes part."""
        self.model = model = copy.copy(_twin(scene))
        self.data = data = mujoco.MjData(model)
        links = [model.body(name).id for name in names.arm_links(side)]
        welded = model.body_weldid[model.geom_bodyid]
        moving = np.isin(welded, links[_FIXED_LINKS:])
        # Two geoms meet where the contype of one has a bit of the other's conaffinity.
        model.geom_contype[:] = moving
        model.geom_conaffinity[:] = 1
        model.geom_margin[:] = np.where(moving, clearance, 0.0)
        # The broad phase has a copy of the margins that is made when compiling.
        model.body_margin[np.unique(model.geom_bodyid[moving])] = clearance
        joints = [model.joint(name).qposadr[0] for name in names.arm_joints(side)]
        self._own = slice(joints[0], joints[0] + wam.N_JOINTS)
        for each in names.SIDES:
            for name, angle in zip(
                names.arm_joints(each), posture.home(each), strict=True
            ):
                data.joint(name).qpos = angle
        self._clearance, self._links = clearance, welded
        self._neighbours = {frozenset((links[a], links[b])) for a, b in _NEIGHBOURS}
        self._site = model.site(names.grasp_site(side)).id

    def place_obstacle(self, position: np.ndarray) -> None:
        """Centre (2,) [m] on the table."""
        self.data.mocap_pos[obstacle_mocap(self.model), :2] = position

    def __call__(self, joints: np.ndarray) -> bool:
        """Whether the arm is free at joint angles (7,) [rad]."""
        data = self.data
        data.qpos[self._own] = joints
        mujoco.mj_kinematics(self.model, data)
        mujoco.mj_collision(self.model, data)
        if data.ncon == 0:
            return True
        distance = data.contact.dist[: data.ncon]
        pairs = self._links[data.contact.geom[: data.ncon]]
        return not any(
            d <= 0 or (d < self._clearance and frozenset(pair) not in self._neighbours)
            for d, pair in zip(distance.tolist(), pairs.tolist(), strict=True)
        )

    def hand_pose(self, joints: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Position (3,) [m] and rotation (3, 3) of the grasp site."""
        self.data.qpos[self._own] = joints
        mujoco.mj_kinematics(self.model, self.data)
        position = self.data.site_xpos[self._site].copy()
        return position, self.data.site_xmat[self._site].reshape(3, 3).copy()


@functools.cache
def _twin(scene: SceneSettings) -> mujoco.MjModel:
    return compile_twin(scene, posture.OPEN)


@dataclass(frozen=True)
class PlannerSettings:
    step: float = 0.03
    """Between checked points of an edge, Euclidean [rad]."""
    extension: float = 0.4
    """Longest edge of a tree [rad]."""
    budget: int = 200_000
    """Collision checks until the search is given up."""


class Tree:
    """Nodes (n, d) [rad] and their parents; a root is its own parent."""

    def __init__(self, roots: np.ndarray) -> None:
        self._nodes, self._n = np.array(roots), len(roots)
        self._parents = list(range(len(roots)))

    def nearest(self, point: np.ndarray) -> int:
        offsets = self._nodes[: self._n] - point
        return int(np.argmin(np.einsum("ij,ij->i", offsets, offsets)))

    def node(self, index: int) -> np.ndarray:
        return self._nodes[index]

    def add(self, point: np.ndarray, parent: int) -> int:
        if self._n == len(self._nodes):
            self._nodes = np.concatenate([self._nodes, np.empty_like(self._nodes)])
        self._nodes[self._n] = point
        self._parents.append(parent)
        self._n += 1
        return self._n - 1

    def to_root(self, index: int) -> list[np.ndarray]:
        points = [self._nodes[index]]
        while self._parents[index] != index:
            index = self._parents[index]
            points.append(self._nodes[index])
        return points


class Search:
    """Collision checks with a budget."""

    def __init__(
        self,
        free: Callable[[np.ndarray], bool],
        settings: PlannerSettings,
        rng: np.random.Generator,
    ) -> None:
        self._free, self._settings, self._rng = free, settings, rng
        self.checks = 0

    @property
    def exhausted(self) -> bool:
        return self.checks >= self._settings.budget

    def edge_is_free(self, start: np.ndarray, end: np.ndarray) -> bool:
        """Whether all points of a straight edge but its start are free."""
        n = max(1, int(np.ceil(np.linalg.norm(end - start) / self._settings.step)))
        # In random order, which finds an obstacle sooner than from one end on.
        for share in (1 + self._rng.permutation(n)) / n:
            self.checks += 1
            if not self._free(start + share * (end - start)):
                return False
        return True

    def extend(self, tree: Tree, index: int, target: np.ndarray) -> int | None:
        """A new node at most one extension nearer to the target, if the way is free."""
        start = tree.node(index)
        offset = target - start
        length = float(np.linalg.norm(offset))
        reach = self._settings.extension
        end = target if length <= reach else start + offset * (reach / length)
        return tree.add(end, index) if self.edge_is_free(start, end) else None

    def connect(self, tree: Tree, target: np.ndarray) -> int | None:
        """Extend again and again; the node at the target if it is reached."""
        index: int | None = tree.nearest(target)
        while index is not None and not np.array_equal(tree.node(index), target):
            index = self.extend(tree, index, target)
        return index


def plan(
    free: Callable[[np.ndarray], bool],
    start: np.ndarray,
    goals: np.ndarray,
    limits: tuple[np.ndarray, np.ndarray],
    rng: np.random.Generator,
    settings: PlannerSettings | None = None,
) -> np.ndarray | None:
    """A path of straight free edges from the start to one of the goals.

    Args:
        free: whether a point (d,) is free.
        start: (d,) [rad]
        goals: (g, d) [rad]; those that aren't free are left out.
        limits: lower and upper bounds of what is searched (d,) [rad].
        rng: decides alone about the answer.
        settings: steps and budget.

    Returns:
        Points (m, d) [rad], or None where the budget ends first.
    """
    settings = PlannerSettings() if settings is None else settings
    search = Search(free, settings, rng)
    goals = np.array([goal for goal in goals if free(goal)])
    if not (len(goals) and free(start)):
        return None
    for goal in goals[np.argsort(np.linalg.norm(goals - start, axis=1))]:
        if search.edge_is_free(start, goal):
            return np.array([start, goal])
    ours, theirs = Tree(start[None]), Tree(goals)
    from_start = True
    while not search.exhausted:
        sample = rng.uniform(*limits)
        grown = search.extend(ours, ours.nearest(sample), sample)
        if grown is not None:
            met = search.connect(theirs, ours.node(grown))
            if met is not None:
                path = ours.to_root(grown)[::-1] + theirs.to_root(met)[1:]
                return np.array(path if from_start else path[::-1])
        ours, theirs, from_start = theirs, ours, not from_start
    return None
