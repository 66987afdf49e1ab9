"""A referee's instrument: looks at every physics step for what must not happen.

It reads the simulator's contact list and forces, which no controller may.
"""

from collections import Counter
from dataclasses import dataclass, field

import mujoco
import numpy as np

from prospect_mj.sim.scene import JAR, PEDESTAL, WELL


@dataclass
class Findings:
    """What an audit saw, summed over all steps."""

    steps: int = 0
    contacts: Counter[tuple[str, str]] = field(default_factory=Counter)
    """Physics steps with an unintended contact, by the pair of geoms."""
    saturated: Counter[str] = field(default_factory=Counter)
    """Physics steps with an actuator at its limit, by its joint."""
    load: float = 0.0
    """Largest share of its torque limit that any arm joint used [1]."""


class Audit:
    """Watches a simulation; attach it with `Simulation.observer`.

    Intended are contacts of a fingertip with the jar and of the jar with its cradle
    and with the receptacle.

    Args:
        model: the scene.
        arm_joints: names of the joints whose torque is watched.
    """

    def __init__(self, model: mujoco.MjModel, arm_joints: list[str]) -> None:
        """Look up what is intended."""
        self._model = model
        self._names = [model.geom(i).name for i in range(model.ngeom)]
        self._kinds = np.array([_kind(name) for name in self._names])
        self._joints = arm_joints
        ids = [model.joint(name).id for name in arm_joints]
        self._dofs = model.jnt_dofadr[ids]
        self._limits = model.jnt_actfrcrange[ids, 1]
        self.findings = Findings()

    def __call__(self, data: mujoco.MjData) -> None:
        """Look at the state after a physics step."""
        self.findings.steps += 1
        for pair in data.contact.geom[: data.ncon]:
            if not _intended(*self._kinds[pair]):
                first, second = sorted(self._names[i] for i in pair)
                self.findings.contacts[first, second] += 1
        share = np.abs(data.qfrc_actuator[self._dofs]) / self._limits
        self.findings.load = max(self.findings.load, float(share.max()))
        for i in np.flatnonzero(share >= 1.0 - 1e-9):
            self.findings.saturated[self._joints[i]] += 1


def _kind(name: str) -> str:
    for kind in (JAR, PEDESTAL, WELL):
        if name.startswith(f"{kind}/"):
            return kind
    return "fingertip" if name.endswith("_tip") else "other"


def _intended(first: str, second: str) -> bool:
    partners = {"fingertip", PEDESTAL, WELL}
    return (first == JAR and second in partners) or (
        second == JAR and first in partners
    )
