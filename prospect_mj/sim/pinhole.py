"""The pinhole model of an eye: which ray a pixel sees, and where a point appears.

Pixels are (column, row) with the centre of the top left one at (0, 0), and camera axes
are right, down, forward, as in OpenCV; MuJoCo's cameras look along -z with y up.
"""

from dataclasses import dataclass
from typing import Self

import mujoco
import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.checks import check_choice
from prospect_mj.errors import InvalidValue

# From MuJoCo's right, up, backward to right, down, forward.
_FLIP = np.diag([1.0, -1.0, -1.0])


@dataclass(frozen=True, eq=False)
class Pinhole:
    """An ideal camera without distortion, calibrated in the world frame."""

    position: NDArray[np.float64]
    """Of the optical centre, (3,) [m]."""
    rotation: NDArray[np.float64]
    """World from camera, (3, 3); its columns are right, down, forward."""
    focal: float
    """Focal length [pixels], the same for columns and rows."""
    size: tuple[int, int]
    """Columns and rows of the image [pixels]."""

    @classmethod
    def of_model(cls, model: mujoco.MjModel, name: str, size: tuple[int, int]) -> Self:
        """Calibrate from the model: what a checkerboard would tell of a fixed eye.

        Raises:
            InvalidChoice: if the model has no such camera.
            InvalidValue: if the camera's body can move, as then no pose is its own.
        """
        names = [model.camera(i).name for i in range(model.ncam)]
        check_choice("camera", name, names)
        camera = model.camera(name)
        if model.body_weldid[camera.bodyid[0]] != 0:
            raise InvalidValue("camera", name, "a camera fixed to the world")
        data = mujoco.MjData(model)
        mujoco.mj_kinematics(model, data)
        mujoco.mj_camlight(model, data)
        view = data.camera(name)
        focal = 0.5 * size[1] / np.tan(0.5 * np.radians(camera.fovy[0]))
        return cls(view.xpos.copy(), view.xmat.reshape(3, 3) @ _FLIP, focal, size)

    @property
    def centre(self) -> NDArray[np.float64]:
        """Principal point (2,) [pixels]."""
        return (np.array(self.size) - 1) / 2

    @property
    def intrinsics(self) -> NDArray[np.float64]:
        """K (3, 3), from camera axes to homogeneous pixels."""
        column, row = self.centre
        return np.array([[self.focal, 0, column], [0, self.focal, row], [0, 0, 1]])

    @property
    def projection(self) -> NDArray[np.float64]:
        """P = K [R^T | -R^T c] (3, 4), from the world to homogeneous pixels."""
        turned = self.rotation.T
        shift = -turned @ self.position
        return self.intrinsics @ np.column_stack([turned, shift])

    def project(self, points: ArrayLike) -> NDArray[np.float64]:
        """Pixels (n, 2) at which the points (n, 3) [m] appear."""
        local = (np.asarray(points) - self.position) @ self.rotation
        return self.focal * local[:, :2] / local[:, 2:] + self.centre

    def rays(self, pixels: ArrayLike) -> NDArray[np.float64]:
        """Unit vectors (n, 3) in the world along which the pixels (n, 2) look."""
        plane = (np.asarray(pixels, dtype=float) - self.centre) / self.focal
        local = np.column_stack([plane, np.ones(len(plane))])
        world = local @ self.rotation.T
        return world / np.linalg.norm(world, axis=1, keepdims=True)
