"""The live physics: owner of MjModel and MjData, and the only caller of mj_step."""

from collections.abc import Callable

import mujoco
import numpy as np

from prospect_mj.errors import InvalidValue, SimulationDiverged
from prospect_mj.sim.placement import JarPlacement
from prospect_mj.sim.scene import (
    JAR,
    PEDESTAL,
    SceneSettings,
    compile_scene,
    obstacle_mocap,
)

_STATE = mujoco.mjtState.mjSTATE_INTEGRATION

SETTLING_TIME = 0.2
"""How long the jar may rock in its cradle before a trial begins [s]."""


class Simulation:
    """Full physics of the torso, the jar and what stands around them.

    Attributes:
        model: the compiled scene.
        data: its live state; read it, but let only this class change or step it.
        observer: called with the state after every physics step; must not change it.
    """

    def __init__(self, settings: SceneSettings | None = None) -> None:
        """Compile the scene and reset it to the home keyframe."""
        self.settings = SceneSettings() if settings is None else settings
        self.model = compile_scene(self.settings)
        self.data = mujoco.MjData(self.model)
        self.observer: Callable[[mujoco.MjData], None] | None = None
        self._jar = self.model.body(f"{JAR}/").id
        self._jar_qpos = int(self.model.jnt_qposadr[self.model.body_jntadr[self._jar]])
        pedestal = self.model.body(f"{PEDESTAL}/").id
        self._mocap = int(self.model.body_mocapid[pedestal])
        self._bulb_diffuse = self.model.light_diffuse.copy()
        mujoco.mj_resetDataKeyframe(self.model, self.data, 0)
        mujoco.mj_forward(self.model, self.data)

    @property
    def timestep(self) -> float:
        """Physics timestep [s]."""
        return self.model.opt.timestep

    def reset(self, placement: JarPlacement, lamp_gain: float = 1.0) -> None:
        """Home the torso, put the jar in its cradle and let it come to rest.

        Args:
            placement: where the jar lies.
            lamp_gain: brightness of the lamp relative to its nominal.
        """
        mujoco.mj_resetDataKeyframe(self.model, self.data, 0)
        self.model.light_diffuse[:] = lamp_gain * self._bulb_diffuse
        turn = _about_z(placement.yaw)
        self.data.mocap_pos[self._mocap] = placement.position
        self.data.mocap_quat[self._mocap] = turn
        lying = np.empty(4)
        tilt = -np.pi / 2 if placement.lid_left else np.pi / 2
        mujoco.mju_axisAngle2Quat(lying, np.array([1.0, 0.0, 0.0]), tilt)
        quat = np.empty(4)
        mujoco.mju_mulQuat(quat, turn, lying)
        start = self._jar_qpos
        self.data.qpos[start : start + 3] = placement.position
        self.data.qpos[start + 3 : start + 7] = quat
        mujoco.mj_forward(self.model, self.data)
        self.step(round(SETTLING_TIME / self.timestep))

    def place_obstacle(self, position: np.ndarray) -> None:
        """Put the obstacle somewhere on the table: centre (2,) [m]; `reset` undoes it.

        Raises:
            InvalidValue: if the scene has none.
        """
        self.data.mocap_pos[obstacle_mocap(self.model), :2] = position
        mujoco.mj_forward(self.model, self.data)

    def step(self, n: int) -> None:
        """Advance the physics by `n` timesteps.

        Raises:
            SimulationDiverged: if MuJoCo raised a warning on the way.
        """
        if self.observer is None:
            mujoco.mj_step(self.model, self.data, n)
        else:
            for _ in range(n):
                mujoco.mj_step(self.model, self.data)
                self.observer(self.data)
        if self.data.warning.number.any():
            raised = np.flatnonzero(self.data.warning.number)
            kinds = [mujoco.mjtWarning(int(i)).name for i in raised]
            raise SimulationDiverged(f"MuJoCo warned of {', '.join(kinds)}")

    def substeps(self, period: float) -> int:
        """Timesteps in a control period [s], which must be a whole number of them."""
        n = round(period / self.timestep)
        if n < 1 or abs(n * self.timestep - period) > 1e-9:
            expected = f"a multiple of the physics timestep {self.timestep} s"
            raise InvalidValue("control period", period, expected)
        return n

    @property
    def jar_position(self) -> np.ndarray:
        """The jar's true centre (3,) [m]: for scoring and the truth ablation only."""
        return self.data.xpos[self._jar].copy()

    @property
    def jar_axis(self) -> np.ndarray:
        """The jar's true axis towards the lid (3,), for the same uses only."""
        return self.data.xmat[self._jar].reshape(3, 3)[:, 2].copy()

    def refresh(self) -> None:
        """Sense anew, so that what follows depends on the saved state alone.

        After a step the sensors and poses are those from before it.
        """
        mujoco.mj_forward(self.model, self.data)

    def save(self) -> np.ndarray:
        """The whole state, from which stepping continues bit-identically.

        The lamp's brightness belongs to the model and is not part of it, nor are the
        sensors' last readings; see `refresh`.
        """
        state = np.empty(mujoco.mj_stateSize(self.model, _STATE))
        mujoco.mj_getState(self.model, self.data, state, _STATE)
        return state

    def restore(self, state: np.ndarray) -> None:
        """Go back to a saved state."""
        mujoco.mj_setState(self.model, self.data, state, _STATE)
        self.refresh()


def _about_z(angle: float) -> np.ndarray:
    quat = np.empty(4)
    mujoco.mju_axisAngle2Quat(quat, np.array([0.0, 0.0, 1.0]), angle)
    return quat
