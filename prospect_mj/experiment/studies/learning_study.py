"""How fast the paper's learner learns from given pictures, all else being ideal.

Many runs of the learner on banks of histograms, as the paper's section 3.2: without a
dominant hand (random orientations from the start) and with one (pretraining with one
orientation, then random ones). The published figures are near-optimal after about 650
trials, after about 250 trials of pretraining, and a peak of over six actions when the
random orientations begin.
"""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent import LinearQ
from prospect_mj.agent.features import FeatureSettings, StateFeatureGenerator
from prospect_mj.agent.settings import LinearSettings
from prospect_mj.checks import check_choice
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.populations.compiled_learner import (
    rule_of,
    run_frozen,
    run_trials,
)
from prospect_mj.experiment.populations.kernels.graph import Trials
from prospect_mj.experiment.populations.outcome_graph import (
    HANDS,
    ideal_graph,
    ideal_root,
)
from prospect_mj.experiment.run.learning_curve import (
    BLOCK,
    OPTIMUM,
    block_means,
    smoothed_near_optimal_trial,
)
from prospect_mj.experiment.studies.histogram_banks import Bank, HistogramBanks
from prospect_mj.task.presentation import ORIENTATIONS, Orientation

_ROOT = dict(zip(ORIENTATIONS, map(ideal_root, HANDS), strict=True))


@dataclass(frozen=True)
class StudySettings:
    """Size and conditions of the study."""

    runs: int = 100
    """Runs of the learner per condition."""
    trials: int = 1000
    """Trials per run."""
    pretrain: int = 400
    """Of these, pretraining, in the condition with a dominant hand."""
    dominant: Orientation = "right"
    """The lid's side in the pretraining."""
    max_actions: int = 10
    """A trial is cut off after this many actions."""
    seed: int = 0
    """Equal seeds give equal studies."""
    features: FeatureSettings = field(default_factory=FeatureSettings)
    """The state features."""
    learner: LinearSettings = field(default_factory=LinearSettings)
    """The learner."""

    def __post_init__(self) -> None:
        """Refuse numbers and choices that make no study."""
        check_choice("dominant hand", self.dominant, ORIENTATIONS)
        if self.runs < 1:
            raise InvalidValue("runs", self.runs, "at least 1")
        if not BLOCK <= self.pretrain <= self.trials - 3 * BLOCK:
            raise InvalidValue(
                "pretraining trials",
                self.pretrain,
                f"{BLOCK} to {self.trials - 3 * BLOCK} of {self.trials} trials",
            )


@dataclass(frozen=True)
class LearningStudy:
    """What the study found; trials as `smoothed_near_optimal_trial` counts."""

    baseline_curve: NDArray[np.float64]
    """(trials // 10,) [actions] over sets of ten trials, without a dominant hand."""
    dominant_curve: NDArray[np.float64]
    """(trials // 10,) [actions] over sets of ten trials, with a dominant hand."""
    near_optimal: int | None
    """Trial from which the first curve is near-optimal and stays so."""
    pretraining_near_optimal: int | None
    """Trial from which the pretraining is."""
    peak_after_switch: float
    """Largest mean actions of a set in the 30 trials after the pretraining."""
    held_out_actions: float
    """Mean actions of the frozen policies on the pictures held out; optimum 2."""
    held_out_optimal: float
    """Share of these solved in two actions [1]."""


def learning_study(
    banks: HistogramBanks, settings: StudySettings | None = None
) -> LearningStudy:
    """Run the learner in both conditions and sum up.

    Args:
        banks: what the learner sees.
        settings: size of the study.
    """
    settings = StudySettings() if settings is None else settings
    train = _scaled(banks.train, settings.features)
    test = _scaled(banks.test, settings.features)
    runs = [_run(train, test, settings, number) for number in range(settings.runs)]
    baseline = block_means([run.baseline for run in runs])
    dominant = block_means([run.dominant for run in runs])
    held_out = np.concatenate([run.held_out for run in runs])
    switch = settings.pretrain // BLOCK
    return LearningStudy(
        baseline_curve=baseline,
        dominant_curve=dominant,
        near_optimal=smoothed_near_optimal_trial(baseline),
        pretraining_near_optimal=smoothed_near_optimal_trial(dominant[:switch]),
        peak_after_switch=float(dominant[switch : switch + 3].max()),
        held_out_actions=float(held_out.mean()),
        held_out_optimal=float(np.mean(held_out == OPTIMUM)),
    )


class _Run(NamedTuple):
    baseline: NDArray[np.int8]
    dominant: NDArray[np.int8]
    held_out: NDArray[np.int8]


def _run(train: Bank, test: Bank, settings: StudySettings, number: int) -> _Run:
    """One learner per condition; (n,) actions per trial and held-out picture."""
    seed = np.random.SeedSequence(settings.seed, spawn_key=(number,))
    rng = np.random.default_rng(seed)
    sides = rng.choice(ORIENTATIONS, settings.trials)
    baseline, learner = _learn(train, sides, settings, rng)
    sides[: settings.pretrain] = settings.dominant
    dominant, _ = _learn(train, sides, settings, rng)
    held_out = _test(test, learner, settings, rng)
    return _Run(baseline, dominant, held_out)


def _learn(
    bank: Bank,
    sides: NDArray[np.str_],
    settings: StudySettings,
    rng: np.random.Generator,
) -> tuple[NDArray[np.int8], LinearQ]:
    """Actions (n_trials,) of a new learner, and what it has become."""
    learner = LinearQ(settings.learner, rng=rng)
    histograms = np.stack([rng.choice(bank[side]) for side in sides])
    trials = _trials(histograms, sides, settings, rng)
    rule = rule_of(settings.learner, settings.features.reading == "one_hot")
    walked = run_trials(learner, ideal_graph(), trials, rule, rng)
    return walked.outcomes.n_actions, learner


def _test(
    bank: Bank,
    learner: LinearQ,
    settings: StudySettings,
    rng: np.random.Generator,
) -> NDArray[np.int8]:
    """Actions (n_pictures,) of the frozen policy on every picture of `bank`."""
    histograms = np.concatenate([bank[side] for side in ORIENTATIONS])
    sides = np.repeat(ORIENTATIONS, [len(bank[side]) for side in ORIENTATIONS])
    trials = _trials(histograms, sides, settings, rng)
    one_hot = settings.features.reading == "one_hot"
    return run_frozen(learner, ideal_graph(), trials, one_hot).n_actions


def _trials(
    histograms: NDArray[np.float64],
    sides: NDArray[np.str_],
    settings: StudySettings,
    rng: np.random.Generator,
) -> Trials:
    n_trials = len(sides)
    return Trials(
        root=np.array([_ROOT[side] for side in sides], np.int32),
        image=np.arange(n_trials, dtype=np.int32),
        visual=histograms,
        orientation=np.array([ORIENTATIONS.index(side) for side in sides]),
        phase=np.zeros(n_trials, np.int32),
        draws=rng.random((n_trials, settings.max_actions, 2)),
    )


def _scaled(bank: Bank, features: FeatureSettings) -> Bank:
    scale = StateFeatureGenerator(features).scaled_histogram
    return {side: np.stack([scale(raw) for raw in bank[side]]) for side in ORIENTATIONS}
