"""A run that pictures are of: the same whenever they are drawn."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.view.run_view import RunView

NAME = "train-0001"
"""As in the commands that the pages begin with."""


@contextmanager
def recorded_run(trials: int) -> Iterator[RunView]:
    """Learn on the shipped recording, seed 0, in a folder that goes afterwards.

    Args:
        trials: of the run.
    """
    with TemporaryDirectory() as place:
        path = Path(place) / NAME
        config = TrainConfig(trials=trials, physics="recorded")
        session.start(config, path, say=lambda words: None)
        yield RunView.read(path)
