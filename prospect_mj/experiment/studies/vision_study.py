"""How well vision sees: many presentations of the real scene, with the truth beside.

The studies of the learner draw from the histograms that are recorded here.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.closing import Closing
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.studies.histogram_banks import Bank, HistogramBanks
from prospect_mj.sim.camera import EyeSettings, StereoCamera, StereoPair
from prospect_mj.sim.pinhole import Pinhole
from prospect_mj.sim.scene import SceneSettings
from prospect_mj.sim.simulation import Simulation
from prospect_mj.task.presentation import (
    ORIENTATIONS,
    Orientation,
    PresentationSettings,
    draw_presentation,
)
from prospect_mj.vision.look import Look
from prospect_mj.vision.vision_controller import VisionController, VisionSettings


@dataclass(frozen=True)
class VisionStudySettings:
    """What is presented, and how often."""

    train: int = 200
    """Images per orientation for the learner to learn from."""
    test: int = 100
    """Images per orientation that are held out."""
    seed: int = 11
    """Equal seeds give equal images."""
    scene: SceneSettings = field(default_factory=SceneSettings)
    presentation: PresentationSettings = field(default_factory=PresentationSettings)
    eyes: EyeSettings = field(default_factory=EyeSettings)
    vision: VisionSettings = field(default_factory=VisionSettings)

    def __post_init__(self) -> None:
        """Refuse a study of nothing."""
        for name in ("train", "test"):
            if not 1 <= getattr(self, name) <= 10_000:
                raise InvalidValue(name, getattr(self, name), "1 to 10000 images")


class Sample(NamedTuple):
    """One presentation: what was seen, and the truth."""

    pair: StereoPair
    look: Look
    position: NDArray[np.float64]
    """The jar's true centre (3,) [m]."""
    axis: NDArray[np.float64]
    """Its true axis (3,) towards the left."""
    seconds: float
    """From asking for the images to the result of the look [s]."""

    @property
    def position_error(self) -> float:
        """[m]; infinite for a pose that was refused."""
        if self.look.position is None:
            return np.inf
        return float(np.linalg.norm(self.look.position - self.position))

    @property
    def axis_error(self) -> float:
        """[rad]; infinite for a pose that was refused."""
        if self.look.axis is None:
            return np.inf
        return float(np.arccos(np.clip(self.look.axis @ self.axis, -1.0, 1.0)))


class Observatory(Closing):
    """The scene, the eyes and the vision controller; closes the eyes at the end."""

    def __init__(self, settings: VisionStudySettings) -> None:
        """Compile the scene and open the eyes.

        Raises:
            RenderingUnavailable: if there is no OpenGL.
        """
        self._settings = settings
        self._simulation = Simulation(settings.scene)
        self._camera = StereoCamera(self._simulation.model, settings.eyes)
        self._vision = VisionController(*self.eyes, settings.vision)

    @property
    def eyes(self) -> tuple[Pinhole, Pinhole]:
        """Calibration of the left and the right eye."""
        return self._camera.left, self._camera.right

    def sample(self, orientation: Orientation, rng: np.random.Generator) -> Sample:
        """Present the jar at random with the lid on this side, and look."""
        nominal = self._settings.scene.props.pedestal.nominal
        drawn = draw_presentation(
            self._settings.presentation, nominal, orientation, rng
        )
        simulation = self._simulation
        simulation.reset(drawn.placement, drawn.lamp_gain)
        start = time.perf_counter()
        pair = self._camera.capture(simulation.data, rng)
        look = self._vision.look(pair)
        seconds = time.perf_counter() - start
        to_left = 1.0 if orientation == "left" else -1.0
        axis = to_left * simulation.jar_axis
        return Sample(pair, look, simulation.jar_position, axis, seconds)

    def close(self) -> None:
        """Close the eyes."""
        self._camera.close()


Samples = dict[Orientation, list[Sample]]


def record(
    observatory: Observatory,
    images: int,
    rng: np.random.Generator,
    tick: Callable[[], object] = lambda: None,
) -> Samples:
    """Take so many samples of each orientation, in turn, and call `tick` after each."""
    samples: Samples = {side: [] for side in ORIENTATIONS}
    for _ in range(images):
        for side in ORIENTATIONS:
            samples[side].append(observatory.sample(side, rng))
            tick()
    return samples


def histogram_banks(train: Samples, test: Samples) -> HistogramBanks:
    """What the learner is given of the samples."""
    return HistogramBanks(_bank(train), _bank(test))


def _bank(samples: Samples) -> Bank:
    return {
        side: np.array([sample.look.histogram for sample in taken], dtype=np.float64)
        for side, taken in samples.items()
    }
