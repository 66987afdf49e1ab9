"""Starting and resuming a run: the order in which things may fail.

Whatever can be wrong is found before anything is written: first the folder, then the
environment (a missing model file, no OpenGL), and only then does the run begin.
"""

import time
from collections.abc import Callable, Mapping
from contextlib import closing
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import Any

from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.run import folder_guard, plots
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import (
    Environment,
    MakeEnvironment,
    make_environment,
)
from prospect_mj.experiment.run.finishing import (
    Keeper,
    check_keepable,
    keeper_of,
    work_off,
)
from prospect_mj.experiment.run.kept_episodes import Kept
from prospect_mj.experiment.run.run_folder import RunFolder
from prospect_mj.experiment.run.summary import Summary
from prospect_mj.experiment.run.training import train

Say = Callable[[str], None]

# A file or a pipe would show the words at the end of the run only.
_say_at_once = partial(print, flush=True)


def start(
    config: TrainConfig,
    out: Path | None = None,
    make_env: MakeEnvironment = make_environment,
    say: Say = _say_at_once,
    kept: Kept | None = None,
) -> Summary:
    """Begin a run and bring it to its end.

    Args:
        config: the run.
        out: its folder, new or empty; None for the next free one under runs/.
        make_env: makes the environment.
        say: told where the run is as soon as there is something to find there.
        kept: which trials are kept as episodes; None: none.

    Raises:
        RunFolderError: if `out` can't be had; nothing was written then.
        RecordingError: if episodes of recorded physics are to be kept; the same.
    """
    if out is not None:
        folder_guard.check_free(out)
    with closing(make_env(config)) as env:
        check_keepable(env, kept)
        with RunFolder.create(out, config) as folder:
            again = f"--resume {folder.path} goes on after a stop"
            say(f"training in {folder.path}; {again}")
            return _finish(folder, env, keeper_of(folder, env, kept))


def resume(
    path: Path,
    config: TrainConfig,
    make_env: MakeEnvironment = make_environment,
    say: Say = _say_at_once,
    kept: Kept | None = None,
) -> Summary | None:
    """Continue a run exactly where its last finished trial left it.

    Args:
        path: the run folder.
        config: the run's own configuration, or the same with more trials.
        make_env: makes the environment.
        say: told what is left to do.
        kept: which of the trials that are left are kept as episodes; None: none.

    Returns:
        None if the run was finished already; nothing was written then.

    Raises:
        RunFolderError: if the folder can't be used or holds another run.
    """
    with RunFolder.open(path) as folder:
        check_same_run(path, folder.config, config)
        if folder.n_trials == config.trials and folder.is_finished:
            say(f"{path} is finished: all of its {config.trials} trials are done")
            return None
        with closing(make_env(config)) as env:
            # First, as it may refuse.
            keeper = keeper_of(folder, env, kept)
            folder.extend(config)
            say(f"resuming {path} at trial {folder.n_trials} of {config.trials}")
            return _finish(folder, env, keeper)


def check_same_run(path: Path, stored: TrainConfig, config: TrainConfig) -> None:
    """Refuse to go on with another run, or with one that has more trials.

    Args:
        path: its folder.
        stored: what it is.
        config: what is wanted.

    Raises:
        RunFolderError: with the first difference.
    """
    if config.trials < stored.trials:
        raise RunFolderError(
            f"{path} has {stored.trials} trials; --trials can only add to them"
        )
    if config != stored.with_trials(config.trials):
        if config.haptic_models != stored.haptic_models:
            raise RunFolderError(f"{path} is another run: its haptic models are others")
        wanted, had = _flat(asdict(config)), _flat(asdict(stored))
        # First which learner it is: others have other settings.
        names = ("learner.name", *(name for name in had if name != "trials"))
        name = next(key for key in names if had[key] != wanted[key])
        told = name.removesuffix(".name")
        raise RunFolderError(
            f"{path} is another run: its {told} is {had[name]}, not {wanted[name]}"
        )


def _flat(settings: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Nested settings by the names that they have on the command line."""
    flat: dict[str, Any] = {}
    for name, value in settings.items():
        if isinstance(value, Mapping):
            flat |= _flat(value, f"{prefix}{name}.")
        else:
            flat[prefix + name] = value
    return flat


def _finish(folder: RunFolder, env: Environment, keeper: Keeper | None) -> Summary:
    """Run what is left, draw the learning curve and sum up."""
    first_trial, began = folder.n_trials, time.perf_counter()
    left = train(folder.config, env, folder.learner, first_trial)
    work_off(left, folder, folder.config.trials, keeper)
    folder.write_curve(_curve(folder))
    return Summary.of(folder, first_trial, time.perf_counter() - began)


def _curve(folder: RunFolder) -> bytes:
    config = folder.config
    return plots.learning_curve(
        folder.trials["n_actions"].to_numpy(),
        config.pretrain,
        config.max_actions,
        f"Learning which hand to use, seed {config.seed}",
    )
