"""Histograms of many presentations, which a study of the learner draws from."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Self
from zipfile import BadZipFile

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.features import N_BINS
from prospect_mj.errors import InvalidValue
from prospect_mj.task.presentation import ORIENTATIONS

Bank = Mapping[str, NDArray[np.float64]]


@dataclass(frozen=True)
class HistogramBanks:
    """Raw histograms of many presentations, to learn from and to test on."""

    train: Bank
    """(n_images, 100) [pixels] per orientation."""
    test: Bank
    """(n_images, 100) [pixels] per orientation, never learned from."""

    def __post_init__(self) -> None:
        """Refuse banks that lack an orientation or hold something else."""
        for bank in (self.train, self.test):
            for orientation in ORIENTATIONS:
                shape = np.shape(bank.get(orientation, ()))
                if len(shape) != 2 or shape[0] < 1 or shape[1] != N_BINS:
                    raise InvalidValue(
                        f"{orientation} bank's shape", shape, f"(n_images, {N_BINS})"
                    )

    def save(self, path: Path) -> None:
        """Write the banks to one NumPy archive."""
        with path.open("wb") as stream:
            np.savez_compressed(
                stream,
                train_left=self.train["left"],
                train_right=self.train["right"],
                test_left=self.test["left"],
                test_right=self.test["right"],
            )

    @classmethod
    def load(cls, path: Path) -> Self:
        """Read what `save` wrote.

        Raises:
            InvalidValue: if the file can't be read or lacks a bank.
        """
        try:
            with np.load(path, allow_pickle=False) as archive:
                train, test = (
                    {side: archive[f"{name}_{side}"] for side in ORIENTATIONS}
                    for name in ("train", "test")
                )
        except (OSError, ValueError, KeyError, BadZipFile) as error:
            raise InvalidValue(
                "histogram banks", str(path), "a file written by HistogramBanks.save"
            ) from error
        return cls(train, test)
