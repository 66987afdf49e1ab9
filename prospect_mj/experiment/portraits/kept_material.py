"""What the kept episodes of a run have for its pictures, read once."""

import warnings
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from tqdm import tqdm

from prospect_mj.episodes import episode_file
from prospect_mj.errors import EpisodeError
from prospect_mj.experiment.portraits.grasp_phases import GraspPhases, grasps_of
from prospect_mj.experiment.run.kept_episodes import path_of
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.task.presentation import ORIENTATIONS, Orientation


@dataclass(frozen=True, eq=False)
class KeptMaterial:
    """What was seen and grasped in the trials that a run has kept."""

    counts: dict[Orientation, NDArray[np.int64]]
    """(n, 100) [pixels] per side of the lid, n may be 0."""
    grasps: tuple[GraspPhases, ...]
    episodes: int
    """How many were read."""


def read_kept(run: RunView) -> KeptMaterial:
    """Read the kept episodes of the finished trials, none if there are none.

    What is damaged or of another run is left out, with a warning.
    """
    kept, refused = run.kept_trials, []
    seen, grasps = {side: [] for side in ORIENTATIONS}, []
    for trial in tqdm(kept, "reading", unit="episode", disable=None, leave=False):
        try:
            episode = episode_file.read(path_of(run.path, trial), run.origin)
        except EpisodeError as error:
            refused.append(str(error))
            continue
        seen[episode.presentation.orientation].append(episode.look.histogram)
        grasps += grasps_of(episode)
    if refused:
        told = f"{len(refused)} of the {len(kept)} kept episodes left out"
        warnings.warn(f"{told}: {'; '.join(refused)}", stacklevel=2)
    counts = {side: np.array(rows, np.int64) for side, rows in seen.items()}
    return KeptMaterial(counts, tuple(grasps), len(kept) - len(refused))
