"""The README's picture of Rerun: a late correction while the jar is handed over."""

from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import cv2

from prospect_mj.episodes.episode import Episode
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.pictures.recorded_run import recorded_run
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.experiment.watching import replayed
from prospect_mj.replay.rerun_export import export
from prospect_mj.replay.screenshot import photograph
from prospect_mj.sim.camera import Image

TRIALS = 600
"""Of the run from which the trial is."""
STEPS = 4
"""Learning, simulating a trial again, exporting it, and the viewer's picture."""
WIDTH = 1600
"""Of the picture [pixels]."""
BAR = 36
"""Height of the viewer's bar, which tells of the machine; it is cut off [pixels]."""
_BOTH_HOLD = 0.2
"""So long before the second hand has finished its grasp [s]."""


def replay_picture(tick: Callable[[], object]) -> bytes:
    """What Rerun's viewer shows of a trial of a short run, as PNG.

    Args:
        tick: called after each of the `STEPS`.

    Raises:
        RunFolderError: if the run has no late correction that can be simulated again.
        ChildProcessError: if the viewer can't draw.
    """
    with recorded_run(TRIALS) as run, TemporaryDirectory() as place:
        tick()
        one = _last_late_correction(run)
        tick()
        file, png = Path(place) / "a.rrd", Path(place) / "a.png"
        export(one.episode, one.story, file)
        tick()
        photograph(file, png, _handed_over_at(one.episode))
        shown = cv2.imread(str(png))
    tick()
    strongest = [cv2.IMWRITE_PNG_COMPRESSION, 9]
    _, content = cv2.imencode(".png", panels_of(shown), strongest)
    return content.tobytes()


def panels_of(shown: Image) -> Image:
    """What the viewer shows below its bar, at the picture's width.

    Args:
        shown: (rows, columns, 3), all of it.
    """
    scale = WIDTH / shown.shape[1]
    below = shown[BAR:]
    return cv2.resize(below, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)


def _last_late_correction(run: RunView) -> replayed.Replayed:
    """The last of the shortest that live physics gives again as it was recorded."""
    refused = f"{run.path.name} has no late correction"
    order = [("n_actions", "ascending"), ("trial", "descending")]
    for trial in run.trials.sort_by(order).to_pylist():
        actions = run.actions_of(trial["trial"]).to_pylist()
        if replayed.strategy(trial, actions) != "late correction":
            continue
        try:
            return replayed.replayed(run, trial["trial"], lambda words: None)
        except RunFolderError as error:
            refused = str(error)
    raise RunFolderError(refused)


def _handed_over_at(episode: Episode) -> float:
    """When both hands hold the jar [s], from the beginning of the episode."""
    swap = next(span for span in episode.actions if span.name.startswith("swap"))
    grasp = next(run for run in swap.controllers if run.name == "GraspController")
    return float(grasp.end - _BOTH_HOLD - episode.states.times[0])
