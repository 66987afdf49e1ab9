"""A trial of a run, simulated once more: seeds and actions give all of it again."""

from contextlib import closing
from typing import Any

from tqdm import tqdm

from prospect_mj.actions.action import Action, ActionOutcome
from prospect_mj.episodes.episode import Episode
from prospect_mj.errors import ProspectError, RunFolderError
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.experiment.watching.presented_again import present_again
from prospect_mj.recording.key import RecordingKey


def resimulate(
    run: RunView, trial: dict[str, Any], actions: list[dict[str, Any]]
) -> Episode:
    """Present what was presented, and run the same actions on live physics.

    Args:
        run: the run, or an evaluation.
        trial: its row of the table of trials.
        actions: its rows of the table of actions, in order.

    Raises:
        RunFolderError: if something else comes of it than then, as sources, models or
            versions have changed since.
        RecordingError: if the recording that the run learned from is gone or damaged.
    """
    number = trial["trial"]
    bar = tqdm(actions, f"trial {number}", unit="action", disable=None, leave=False)
    with closing(present_again(run, number, trial["orientation"])) as watched, bar:
        for action in bar:
            _check_same(run, action, watched.execute(Action(action["action"])))
        return watched.episode()


def _check_same(run: RunView, then: dict[str, Any], now: ActionOutcome) -> None:
    had = then["result"], then["sim_seconds"]
    if had == (str(now.result), now.sim_seconds):
        return
    raise RunFolderError(
        f"{run.path}: trial {then['trial']} can't be simulated again: its action "
        f"{then['step'] + 1}, {then['action_name']}, now ends as {now.result} after "
        f"{now.sim_seconds:.2f} s, not as {had[0]} after {had[1]:.2f} s; "
        f"{_what_changed(run)}"
    )


def _what_changed(run: RunView) -> str:
    """Why physics may be another one by now."""
    try:
        changed = run.outdated()
        if run.config.physics == "recorded":
            key = RecordingKey.read(run.config.recording_folder)
            changed += key.differences(RecordingKey.present(key.config))
    except ProspectError as error:
        changed = [str(error)]
    return f"changed since: {', '.join(changed)}" if changed else "the machine differs"
