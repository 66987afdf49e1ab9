"""Digests of what decides on a population: recorded outcomes, and code."""

import json
from pathlib import Path

import numpy as np

from prospect_mj import paths
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.experiment.run.fingerprint import learner_digest
from prospect_mj.recording.provenance import code_digest, sha256, source_digest
from prospect_mj.recording.recording import Recording

_HERE = "experiment/populations"
_SHARED_CODE = (
    *(
        f"{_HERE}/{name}.py"
        for name in (
            "compiled_learner",
            "kernels/graph",
            "kernels/walk",
            "outcome_graph",
            "population",
            "programme",
            "scenario",
            "shown",
            "spread",
            "strategies",
            "recorded_world",
        )
    ),
    "recording/choices.py",
)
_LINEAR_CODE = (f"{_HERE}/kernels/sums.py", f"{_HERE}/twins/sight.py")
_REPLAY_CODE = (f"{_HERE}/kernels/ring.py",)
_OWN_CODE = {
    "linear": _LINEAR_CODE,
    "replay": (*_LINEAR_CODE, *_REPLAY_CODE, f"{_HERE}/kernels/linear.py"),
    "table": _REPLAY_CODE,
    "discovery": (),
}


def recording_digest(recording: Recording) -> str:
    """One digest of what can be learned from a recording, as far as it has grown."""
    nodes, shown = recording.nodes, recording.presentations
    arrays = (
        nodes.child,
        nodes.situation,
        nodes.inserted,
        nodes.holding,
        nodes.predicates,
        shown.root,
        shown.lid,
        shown.histogram,
        shown.depth,
    )
    parts = [recording.key.digest]
    parts += [sha256(np.ascontiguousarray(array).tobytes()) for array in arrays]
    return sha256(json.dumps(parts).encode())


def world_digest(world: RecordedWorld) -> str:
    """One digest of a recording and the categories of its grasps, if there are any."""
    digest = recording_digest(world.recording)
    if world.category is None:
        return digest
    category = sha256(np.ascontiguousarray(world.category, np.int64).tobytes())
    return sha256(f"{digest} {world.categories} {category}".encode())


def code(learner: str, package: Path = Path(paths.__file__).parent) -> str:
    """Digest of the code of this package that decides what a learner learns.

    Args:
        learner: its name.
        package: where the code is.
    """
    files = {name: (package / name).read_text("utf-8") for name in code_files(learner)}
    own = code_digest(files.items())
    return sha256(f"{own} {learner_digest(learner)} {source_digest()}".encode())


def code_files(learner: str) -> list[str]:
    """The files that decide, relative to the package.

    They are beside the learner's own and all that is below learners.
    """
    twins = (f"{_HERE}/kernels/{learner}*.py", f"{_HERE}/twins/{learner}_twin.py")
    package = Path(paths.__file__).parent
    found = {
        path.relative_to(package).as_posix()
        for pattern in twins
        for path in package.glob(pattern)
    }
    return sorted({*_SHARED_CODE, *_OWN_CODE[learner], *found})
