"""Trials as files of Rerun, each by itself: one that fails keeps no other from it."""

import tempfile
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

from tqdm import tqdm

from prospect_mj.cli.new_file import check_new_file, new_folder
from prospect_mj.errors import ProspectError, RunFolderError
from prospect_mj.experiment.watching.replayed import PRODUCT, Fetch
from prospect_mj.replay.rerun_export import export


@contextmanager
def places(
    save: Path | None, into_folder: bool, names: Sequence[str]
) -> Iterator[list[Path]]:
    """Where each trial is to be written; a folder in which nothing is goes again.

    Args:
        save: the file or folder that the user named; None for a passing one.
        into_folder: whether that is a folder.
        names: of the trials.

    Raises:
        InvalidValue: if one of the files is there already, or can't be written.
        ProspectError: if the folder can't be made.
    """
    if save is None:
        with tempfile.TemporaryDirectory(prefix="prospect-replay-") as place:
            yield _named(Path(place), names)
    elif into_folder:
        with new_folder(save):
            files = _named(save, names)
            for path in files:
                check_new_file("--save", path, PRODUCT)
            yield files
    else:
        yield [save]


def _named(folder: Path, names: Sequence[str]) -> list[Path]:
    return [folder / f"{name}{PRODUCT}" for name in names]


def written(trials: Mapping[str, Fetch], files: Sequence[Path]) -> Iterator[Path]:
    """Write trials, and warn of those that can't be.

    Args:
        trials: how to get each, by its name.
        files: where each is written.

    Yields:
        Each file, when it is there as a whole.

    Raises:
        RunFolderError: if of several none came out.
        ProspectError: why the only one didn't.
    """
    refused: dict[str, ProspectError] = {}
    quiet = True if len(trials) == 1 else None
    bar = tqdm(trials.items(), "trials", unit="trial", disable=quiet)
    for path, (name, fetch) in zip(files, bar, strict=True):
        try:
            one = fetch()
            export(one.episode, one.story, path)
        except ProspectError as error:
            refused[name] = error
        else:
            yield path
    if len(refused) == len(trials):
        _refuse(refused)
    for name, error in refused.items():
        warnings.warn(f"{name} is left out: {error}", stacklevel=2)


def _refuse(refused: Mapping[str, ProspectError]) -> None:
    """One line for all of them: what keeps one from coming out mostly keeps all."""
    (name, error), *others = refused.items()
    if not others:
        raise error
    told = f"none of the {len(refused)} trials can be replayed: {name}: {error}"
    raise RunFolderError(told) from error
