"""A study of development that is made in seconds, of worlds made by hand."""

from dataclasses import replace
from functools import partial

import numpy as np
from ideal_recording import ideal, recording

from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.measures.development import Development
from prospect_mj.experiment.development.study import splits
from prospect_mj.experiment.development.study.recordings import Recordings
from prospect_mj.experiment.development.study.settings import (
    CHANGES,
    FELT_WORLDS,
    IMAGE_WORLDS,
    StudySettings,
)
from prospect_mj.recording.worlds import STANDARD

SETTINGS = StudySettings(
    runs=3, setting_runs=2, deep_runs=2, deep_trials=50, grasped=0, planned=0
)
OTHER = {"left": "right", "right": "left"}


def lid_first(state, action, lid):
    """The receptacle takes the lid only, so that the other end is to be held."""
    return ideal(state, action, OTHER[lid])


def noisy(made, deviation, seed):
    """The same outcomes, and other pictures."""
    shown, rng = made.presentations, np.random.default_rng(seed)
    factor = np.abs(1 + deviation * rng.standard_normal(shown.histogram.shape))
    histogram = np.rint(shown.histogram * factor).astype(shown.histogram.dtype)
    return replace(made, presentations=replace(shown, histogram=histogram))


def recordings():
    """Of all worlds: two presentations of each orientation."""
    two = partial(recording, depth=10)
    made = {"post": two(left=(lid_first,) * 2, right=(lid_first,) * 2)}
    standard = two(left=(ideal,) * 2, right=(ideal,) * 2)
    worlds = dict.fromkeys((*IMAGE_WORLDS, *CHANGES, *FELT_WORLDS))
    for number, world in enumerate(worlds):
        deviation = 0.0 if world == STANDARD else 0.1 * number
        made.setdefault(world, noisy(standard, deviation, number))
    return Recordings({STANDARD: made[STANDARD], **made})


def resample_little(patch, n=20):
    """Let all intervals be of so few resamples."""
    for cls in (Findings, Development):
        patch.setattr(cls.of.__func__, "__defaults__", (n,))
    patch.setattr(splits, "RESAMPLES", n)
