"""The option of haptic models: the file that they are read from."""

from pathlib import Path
from typing import Annotated

from tyro.constructors import PrimitiveConstructorSpec

from prospect_mj.haptics import TrajectoryModels


def _read(words: list[str]) -> TrajectoryModels:
    (path,) = words
    return TrajectoryModels.read(Path(path))


def _told(models: TrajectoryModels | None) -> list[str]:
    """What help says of models that are there already: those of a run."""
    return ["none" if models is None else f"{len(models)} models"]


OptionalModels = Annotated[
    TrajectoryModels | None,
    PrimitiveConstructorSpec(
        nargs=1,
        metavar="FILE",
        instance_from_str=_read,
        is_instance=lambda value: isinstance(value, TrajectoryModels | None),
        str_from_instance=_told,
    ),
]
"""As an option: a JSON file, as `TrajectoryModels.write` makes it."""
