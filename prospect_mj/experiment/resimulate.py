"""A trial of a run, simulated once more: seeds and actions give all of it again."""

from contextlib import closing
from pathlib import Path
from typing import Any

from prospect_mj.episodes.episode import Episode
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.config import TrainConfig
from prospect_mj.experiment.environment import make_environment
from prospect_mj.experiment.training import Stream, trial_seed


def resimulate(
    run: Path, config: TrainConfig, trial: dict[str, Any], actions: list[dict[str, Any]]
) -> Episode:
    """Present what was presented, and run the same actions.

    Args:
        run: the run's folder, for the messages.
        config: what the run is.
        trial: its row of the table of trials.
        actions: its rows of the table of actions, in order.

    Raises:
        RunFolderError: if something else comes of it than then, as sources, models or
            versions have changed since.
        RecordingError: if the run learned from recorded physics.
    """
    number = trial["trial"]
    seed = trial_seed(config.seed, number, Stream.PRESENTATION).generate_state(1)[0]
    with closing(make_environment(config)) as env:
        watched = env.watch()
        options = {"orientation": trial["orientation"], "trial": number}
        env.reset(seed=int(seed), options=options)
        for action in actions:
            *_, info = env.step(action["action"])
            if info["result"] != action["result"]:
                raise RunFolderError(
                    f"{run}: trial {number} can't be simulated again: its action "
                    f"{action['step']} now ends as {info['result']}, not "
                    f"{action['result']}; the physics changed since"
                )
        return watched.episode()
