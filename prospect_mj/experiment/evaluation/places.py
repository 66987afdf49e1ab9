"""Which folder an evaluation has: one where it was begun, or a new one."""

from itertools import count
from pathlib import Path

from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.evaluation.evaluation_folder import check_free, is_begun
from prospect_mj.experiment.run.run_files import TRIALS, read_table
from prospect_mj.experiment.view import evaluation_file
from prospect_mj.experiment.view.evaluation_file import StoredEvaluation

FOLDER = "evaluations"
"""In that of the run."""


def place(run: Path, wanted: StoredEvaluation, out: Path | None) -> Path:
    """Find the folder of an evaluation.

    One that was not finished is the same whatever the run has learned since, as it has
    the learner that it began with; a finished one only of the same learner.

    Args:
        run: folder of the run.
        wanted: the evaluation.
        out: its folder; None for one in that of the run.

    Returns:
        A folder in which it is begun, or one that it can have; see `is_begun`.

    Raises:
        RunFolderError: if `out` is occupied.
    """
    if out is None:
        return _default(run / FOLDER, wanted)
    if not is_begun(out):
        check_free(out)
        return out
    other = _difference(out, wanted)
    if other is not None:
        raise RunFolderError(
            f"{out} holds an evaluation {other}; choose another folder"
        )
    return out


def _default(parent: Path, wanted: StoredEvaluation) -> Path:
    """The first of 0001, 0002, ... that is the same evaluation, or is free."""
    numbered = (parent / f"{number:04d}" for number in count(1))
    path = next(path for path in numbered if _can_be(path, wanted))
    if not is_begun(path):
        check_free(path)
    return path


def _can_be(path: Path, wanted: StoredEvaluation) -> bool:
    if is_begun(path):
        return _is_same(path, wanted)
    return not path.exists() or _is_free(path)


def _is_same(path: Path, wanted: StoredEvaluation) -> bool:
    """A damaged one is another one."""
    try:
        return _difference(path, wanted) is None
    except RunFolderError:
        return False


def _is_free(path: Path) -> bool:
    try:
        check_free(path)
    except RunFolderError:
        return False
    return True


def _difference(path: Path, wanted: StoredEvaluation) -> str | None:
    """What of an evaluation that was begun is not as wanted, in words."""
    found = evaluation_file.read(path)
    difference = wanted.difference(found)
    if difference is not None or found.learned == wanted.learned:
        return difference
    if _n_trials(path, found) < found.settings.n_trials:
        return None
    return f"of the learner after {found.learned.trials} trials"


def _n_trials(path: Path, evaluation: StoredEvaluation) -> int:
    if not (path / TRIALS).exists():
        return 0
    return read_table(path, TRIALS, evaluation.origin).num_rows
