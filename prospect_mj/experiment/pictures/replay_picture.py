"""The README's picture of Rerun: a late correction while the jar is handed over."""

from pathlib import Path
from tempfile import TemporaryDirectory

import cv2
import numpy as np

from prospect_mj.episodes.episode import Episode
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.experiment.watching import replayed
from prospect_mj.replay.rerun_export import export
from prospect_mj.replay.screenshot import photograph

TRIALS = 600
"""Of the run from which the trial is."""
SIZE = (1600, 870)
"""Width and height [pixels]."""
_BAR = 36
"""Height of the viewer's bar, which tells of the machine; it is cut off [pixels]."""
_BOTH_HOLD = 0.2
"""So long before the second hand has finished its grasp [s]."""


def replay_picture() -> bytes:
    """What Rerun's viewer shows of a trial of a short run, as PNG.

    Raises:
        RunFolderError: if the run has no late correction that can be simulated again.
        ChildProcessError: if the viewer can't draw.
    """
    with TemporaryDirectory() as place:
        run, file, png = (Path(place) / n for n in ("train-0001", "a.rrd", "a.png"))
        config = TrainConfig(trials=TRIALS, physics="recorded")
        session.start(config, run, say=lambda words: None)
        one = _last_late_correction(run)
        export(one.episode, one.story, file)
        photograph(file, png, _handed_over_at(one.episode))
        shown = cv2.imread(str(png))[_BAR:]
    smaller = cv2.resize(shown, SIZE, interpolation=cv2.INTER_AREA)
    strongest = [cv2.IMWRITE_PNG_COMPRESSION, 9]
    _, content = cv2.imencode(".png", np.ascontiguousarray(smaller), strongest)
    return content.tobytes()


def _last_late_correction(run: Path) -> replayed.Replayed:
    """The last of the shortest that live physics gives again as it was recorded."""
    view = RunView.read(run)
    refused = f"{run.name} has no late correction"
    order = [("n_actions", "ascending"), ("trial", "descending")]
    for trial in view.trials.sort_by(order).to_pylist():
        actions = view.actions_of(trial["trial"]).to_pylist()
        if replayed.strategy(trial, actions) != "late correction":
            continue
        try:
            return next(replayed.replayed(view, [trial["trial"]], lambda words: None))
        except RunFolderError as error:
            refused = str(error)
    raise RunFolderError(refused)


def _handed_over_at(episode: Episode) -> float:
    """When both hands hold the jar [s], from the beginning of the episode."""
    swap = next(span for span in episode.actions if span.name.startswith("swap"))
    grasp = next(run for run in swap.controllers if run.name == "GraspController")
    return float(grasp.end - _BOTH_HOLD - episode.states.times[0])
