"""Live grasps of jars, each share of them in a process of its own, kept as they end."""

import json
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from prospect_mj import tables
from prospect_mj.actions.action import ActionOutcome, ActionResult
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.development.haptics.grasp import (
    CRADLE,
    HAND_OVER,
    SCHEMA,
    Grasp,
    Kind,
    of_table,
    table,
)
from prospect_mj.experiment.development.haptics.settings import HapticSettings
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.grower import task_settings
from prospect_mj.recording.hands import GRASPS, NUMBERS, SWAPS
from prospect_mj.recording.last_grasp import last_grasp
from prospect_mj.recording.provenance import (
    installed_versions,
    model_digests,
    sha256,
    source_digest,
)
from prospect_mj.recording.workers import Workers
from prospect_mj.recording.worlds import WORLDS
from prospect_mj.robot.names import SIDES, Side, other
from prospect_mj.storage import make_folder, replace_file
from prospect_mj.task.pick_place import PickPlaceTask
from prospect_mj.task.presentation import ORIENTATIONS, Orientation

_HAPTICS = 4
"""Begins the seeds of these presentations; a recording's begin with 0 or 1."""


class Share(NamedTuple):
    """Presentations of a jar with its lid on one side."""

    jar: str
    orientation: Orientation
    presentations: int
    seed: int

    @property
    def digest(self) -> str:
        """Of all that decides what is felt."""
        decides = self._asdict() | {
            "world": WORLDS[self.jar].digest,
            "sources": source_digest(),
            "models": model_digests(),
            "versions": installed_versions(),
        }
        return sha256(json.dumps(decides, sort_keys=True).encode())

    @property
    def file(self) -> str:
        """Name of the file that it is kept in."""
        return f"{self.jar}-{self.orientation}-{self.digest[:16]}.parquet"


def grasps(
    folder: Path,
    jars: Sequence[str],
    settings: HapticSettings,
    jobs: int,
    tell: Callable[[str], object],
) -> dict[str, list[Grasp]]:
    """Grasp jars, but for what is kept already.

    Args:
        folder: where grasps are kept; made if it isn't there.
        jars: names of their worlds.
        settings: how often, and the seed of the presentations, which are the same for
            all jars.
        jobs: processes side by side.
        tell: takes a line as each share ends.

    Returns:
        The grasps of each jar; of none if none are to be made.

    Raises:
        RunFolderError: if the folder can't be made, or a file in it is damaged.
        RenderingUnavailable: if there is no OpenGL and something is to be grasped.
        ChildProcessError: if a process was killed.
    """
    make_folder(folder, RunFolderError)
    per_side, seed = settings.per_side, settings.seed
    jars = jars if per_side else ()
    shares = [Share(jar, side, per_side, seed) for jar in jars for side in ORIENTATIONS]
    missing = [share for share in shares if not (folder / share.file).exists()]
    if missing:
        for share, made in Workers(min(jobs, len(missing))).map(_made, missing):
            content = tables.parquet(table(made), share.digest, "zstd")
            replace_file(folder / share.file, content)
            tell(f"{share.jar}, lid {share.orientation}: {len(made)} live grasps")
    found: dict[str, list[Grasp]] = {jar: [] for jar in jars}
    for share in shares:
        rows = tables.read_kept(folder / share.file, SCHEMA, share.digest)
        found[share.jar] += of_table(rows)
    return found


def _made(share: Share) -> tuple[Share, list[Grasp]]:
    return share, grasped(share)


def grasped(share: Share) -> list[Grasp]:
    """Present a jar, take it with either hand, and hand it over; those that held."""
    with PickPlaceTask(task_settings(RecordingConfig(world=share.jar))) as task:
        return [
            grasp
            for number in range(share.presentations)
            for hand in SIDES
            for grasp in _sequence(task, share, number, hand)
        ]


def _sequence(
    task: PickPlaceTask, share: Share, number: int, hand: Side
) -> Iterator[Grasp]:
    """A hand's grasp out of the cradle, and the other one's in the hand-over."""
    key = _HAPTICS, ORIENTATIONS.index(share.orientation), number
    seed = np.random.SeedSequence(share.seed, spawn_key=key)
    task.reset(share.orientation, np.random.default_rng(seed))
    steps: tuple[tuple[Kind, Side, ActionOutcome], ...]
    taken = task.execute(GRASPS[NUMBERS[hand]])
    passed = task.execute(SWAPS[NUMBERS[hand]])
    steps = (CRADLE, hand, taken), (HAND_OVER, other(hand), passed)
    for kind, holder, outcome in steps:
        if outcome.result == ActionResult.SUCCESS:
            yield Grasp(share.orientation, number, holder, kind, last_grasp(outcome))
