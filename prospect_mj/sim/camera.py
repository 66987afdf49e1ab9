"""The pair of eyes in the torso's head: colour images with sensor noise, nothing else.

No depth and no segmentation is rendered, and the eyes do not move: they look at the
place where objects are presented, whatever lies there.
"""

import atexit
import os
from dataclasses import dataclass
from typing import NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from prospect_mj.closing import Closing
from prospect_mj.errors import InvalidValue, RenderingUnavailable
from prospect_mj.sim import gl
from prospect_mj.sim.offscreen import OffscreenRenderer
from prospect_mj.sim.pinhole import Pinhole

Image = NDArray[np.uint8]


class StereoPair(NamedTuple):
    """What both eyes saw at one instant."""

    left: Image
    """(rows, columns, 3) RGB [grey levels]."""
    right: Image
    """The same of the right eye."""


@dataclass(frozen=True)
class EyeSettings:
    """The sensors behind both eyes."""

    names: tuple[str, str] = ("left_eye", "right_eye")
    """Cameras of the model."""
    size: tuple[int, int] = (320, 240)
    """Columns and rows [pixels]."""
    noise_sd: float = 2.0
    """Standard deviation of the noise of each channel of each pixel [grey levels]."""

    def __post_init__(self) -> None:
        """Refuse what no sensor has."""
        if not 0 <= self.noise_sd <= 64:
            raise InvalidValue("noise_sd", self.noise_sd, "0 to 64 grey levels")
        if not (32 <= self.size[0] <= 640 and 32 <= self.size[1] <= 480):
            raise InvalidValue("image size", self.size, "32 x 32 to 640 x 480 pixels")


class StereoCamera(Closing):
    """Renders both eyes; holds an OpenGL context until it is closed.

    A context belongs to the process that made it. After a fork make a new camera.
    """

    def __init__(
        self, model: mujoco.MjModel, settings: EyeSettings | None = None
    ) -> None:
        """Open the eyes of `model`.

        Raises:
            RenderingUnavailable: if there is no OpenGL; the message says what to do.
        """
        gl.require_gl()
        self.settings = EyeSettings() if settings is None else settings
        columns, rows = self.settings.size
        left, right = self.settings.names
        self.left = Pinhole.of_model(model, left, self.settings.size)
        self.right = Pinhole.of_model(model, right, self.settings.size)
        self._process = os.getpid()
        self._renderer: OffscreenRenderer | None = OffscreenRenderer(
            model, rows, columns
        )
        # Left to the interpreter's last collection, MuJoCo's destructor fails noisily.
        atexit.register(self.close)

    def capture(self, data: mujoco.MjData, rng: np.random.Generator) -> StereoPair:
        """Take one image with each eye, left first.

        Args:
            data: the scene; positions of bodies and lights must be up to date.
            rng: source of the sensor noise.
        """
        renderer = self._usable_renderer()
        images = []
        for name in self.settings.names:
            renderer.update_scene(data, name)
            images.append(self._sensed(renderer.render(), rng))
        return StereoPair(*images)

    def close(self) -> None:
        """Give the OpenGL context back; closing again does nothing."""
        # A forked child must not free what is its parent's, not even by dropping it.
        if self._renderer is None or os.getpid() != self._process:
            return
        self._renderer.close()
        self._renderer = None
        atexit.unregister(self.close)

    def _usable_renderer(self) -> OffscreenRenderer:
        if self._renderer is None:
            raise RenderingUnavailable("this camera is closed; make a new StereoCamera")
        if os.getpid() != self._process:
            raise RenderingUnavailable(
                "this camera was opened before a fork; make a StereoCamera in each "
                "process"
            )
        return self._renderer

    def _sensed(self, image: Image, rng: np.random.Generator) -> Image:
        """Add sensor noise, round, and clip to what eight bits hold."""
        if self.settings.noise_sd == 0:
            return image
        noise = rng.standard_normal(image.shape, dtype=np.float32)
        noise *= np.float32(self.settings.noise_sd)
        noise += image
        np.rint(noise, out=noise)
        return np.clip(noise, 0, 255, out=noise).astype(np.uint8)
