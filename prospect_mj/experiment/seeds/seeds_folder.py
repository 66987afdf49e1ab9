"""The folder of runs of several seeds.

    seed-0000, ...       a run folder each
    summary.md           figures of each seed, and over all
    summary.yaml         the same for programs
    learning_curves.png  all of them, and their mean with its band

The last three are of the seeds that were asked for last.
"""

import re
from collections.abc import Sequence
from pathlib import Path

import pyarrow.parquet as pq
from pyarrow.lib import ArrowException

from prospect_mj.experiment.run import folder_guard
from prospect_mj.experiment.run.run_files import CONFIG, CURVE, TRIALS
from prospect_mj.experiment.run.run_folder import read_config
from prospect_mj.experiment.run.session import check_same_run
from prospect_mj.experiment.run.side_by_side import Wanted
from prospect_mj.storage import temporary

DEFAULT = Path("runs/seeds")
SUMMARY, FIGURES, CURVES = "summary.md", "summary.yaml", "learning_curves.png"

_OWN = (SUMMARY, FIGURES, CURVES)
_SEED = re.compile(r"seed-\d{4,}")


def check(out: Path, runs: Sequence[Wanted]) -> None:
    """Refuse what can't be done, before anything is begun.

    Args:
        out: folder of all runs.
        runs: those that there are to be.

    Raises:
        RunFolderError: if `out` is a file, has something else in it, or can't be made;
            or a run in it is another one or can't be gone on with.
    """
    remedy = "choose another folder with --out"
    folder_guard.check_holds_only(out, remedy, _is_own)
    if not all(is_finished(run) for run in runs):
        # What is finished may be summed up again from where nothing can be written.
        folder_guard.check_vacant(out, remedy, _is_own)
    for run in runs:
        if (run.path / CONFIG).exists():
            check_same_run(run.path, read_config(run.path), run.config)
        else:
            folder_guard.check_free(run.path)


def _is_own(name: str) -> bool:
    own = {*_OWN, *(temporary(Path(file)).name for file in _OWN)}
    return name in own or _SEED.fullmatch(name) is not None


def is_finished(run: Wanted) -> bool:
    """Whether nothing is left to do in a run."""
    has_curve = (run.path / CURVE).is_file()
    return has_curve and n_finished(run.path) == run.config.trials


def n_finished(run: Path) -> int:
    """Finished trials of a run, which another process may be adding to."""
    try:
        # Opened here: pyarrow would see an address in a folder called s3:b.
        with (run / TRIALS).open("rb") as stream:
            return pq.read_metadata(stream).num_rows
    except (OSError, ArrowException):
        return 0
