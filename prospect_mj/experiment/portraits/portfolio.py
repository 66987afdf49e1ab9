"""All pictures of one run."""

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray
from tqdm import tqdm

from prospect_mj.agent import LinearQ, StateFeatureGenerator
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.portraits.decisive_bins import MadeUpMind
from prospect_mj.experiment.portraits.histograms import SeenHistograms
from prospect_mj.experiment.portraits.run_frame import name_of
from prospect_mj.experiment.portraits.start_value_picture import start_values
from prospect_mj.experiment.portraits.strategy_picture import strategies
from prospect_mj.experiment.portraits.weights_picture import weights
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.sim import gl
from prospect_mj.task.presentation import Orientation

STRATEGIES = "strategies.png"
VALUES = "q_values.png"
WEIGHTS = "weights.png"
GRASPS = "grasp_portraits.png"
MISLED = "misled_grasps.png"

_LARGEST = 1e300
"""Number that can be drawn: sums of larger ones overflow."""

Draw = Callable[[], bytes]
Say = Callable[[str], None]


def draw(run: RunView, n_misled: int, say: Say) -> dict[str, bytes]:
    """Draw all that there is of a run.

    Args:
        run: the run.
        n_misled: grasps to simulate with a wrong pose of the jar; see `misled_grasps`.
        say: told what can't be drawn, and why.

    Returns:
        Pictures as PNG, by the names of their files.

    Raises:
        RunFolderError: if its numbers have grown too large.
        RecordingError: if the kept episodes don't show both orientations, and the
            recording is damaged.
        RenderingUnavailable: if grasps are to be simulated without OpenGL, or MuJoCo
            can't be loaded for want of it.
    """
    _check_drawable(run)
    work: dict[str, Draw] = {
        STRATEGIES: lambda: strategies(run),
        VALUES: lambda: start_values(run),
    }
    if run.kept_trials:
        work |= _of_episodes(run)
    else:
        work[WEIGHTS] = lambda: weights_of(run, {})
    if not isinstance(run.learner, LinearQ):
        del work[WEIGHTS]
        say(f"no {WEIGHTS}: {_no_weights(run)}")
    elif run.config.categories:
        say(f"{WEIGHTS} leaves out the weights of the haptic categories")
    if n_misled:
        work[MISLED] = lambda: _misled(run, n_misled)
    elif GRASPS not in work:
        say(_why_no_grasps(run))
    bar = tqdm(work.items(), "drawing", unit="picture", disable=None, leave=False)
    return {name: picture() for name, picture in bar}


def _check_drawable(run: RunView) -> None:
    """Refuse a run that learned nothing but to overflow."""
    q_values = np.array(run.actions["q_values"].to_pylist())
    learned = run.learner.state().values()
    largest = max(np.abs(array).max(initial=0) for array in (q_values, *learned))
    if largest > _LARGEST:
        grown = f"its values have grown to {largest:.0e}"
        raise RunFolderError(f"{run.path} can't be drawn: {grown}")


def _of_episodes(run: RunView) -> dict[str, Draw]:
    # Where nothing was simulated, nothing of MuJoCo is loaded.
    try:
        from prospect_mj.experiment.portraits.grasp_picture import portraits
        from prospect_mj.experiment.portraits.kept_material import read_kept
    except Exception:
        # MuJoCo loads OpenGL, and has an error of its own for each way to lack it.
        gl.require_gl()
        raise
    kept = read_kept(run)
    work: dict[str, Draw] = {WEIGHTS: lambda: weights_of(run, kept.counts)}
    if kept.grasps:
        of = f"{name_of(run)}: every grasp of the {kept.episodes} kept episodes"
        work[GRASPS] = lambda: portraits(kept.grasps, of)
    return work


def weights_of(run: RunView, kept: Mapping[Orientation, NDArray[np.int64]]) -> bytes:
    """Draw which grey levels decide in a run.

    Args:
        run: the run.
        kept: (n, 100) [pixels] per side of the lid: histograms of its kept episodes.

    Raises:
        RunFolderError: if its learner has no weights of grey levels.
        RecordingError: if those lack a side, and the recording is damaged.
    """
    if not isinstance(run.learner, LinearQ):
        raise RunFolderError(f"{run.path} can't be drawn: {_no_weights(run)}")
    config = run.config
    seen = SeenHistograms.of(kept, config)
    generator = StateFeatureGenerator(config.features, config.categories)
    mind = MadeUpMind.of(run.learner, generator, seen.counts)
    of = f"{name_of(run)}, after {run.n_trials} trials; histograms of {seen.source}"
    return weights(mind, config.features.reading, of)


def _no_weights(run: RunView) -> str:
    name = run.learner.settings.name
    return f"it needs a linear learner, and this is a {name} learner"


def _misled(run: RunView, n: int) -> bytes:
    from prospect_mj.experiment.portraits.grasp_picture import portraits
    from prospect_mj.experiment.portraits.misled_grasps import (
        MisledSettings,
        grasp_misled,
    )

    rng, wrong = np.random.default_rng(run.config.seed), MisledSettings()
    grasps = list(grasp_misled(run.config, n, rng, wrong))
    of = (
        f"{len(grasps)} grasps of a jar that the robot is told to lie elsewhere: "
        f"errors of {1000 * wrong.position_sd:g} mm and {wrong.angle_sd:g} rad"
    )
    return portraits(grasps, of)


def _why_no_grasps(run: RunView) -> str:
    if run.config.physics == "recorded":
        why = "a run on recorded physics has no episodes"
    elif run.kept_trials:
        why = "the kept episodes show no grasp"
    else:
        why = "the run kept no episodes, as --record every=50 of the training would"
    return f"no {GRASPS}: {why}; --grasps 12 simulates some grasps"
