"""Intervals against what eight thousand recorded runs come to, of other seeds."""

from dataclasses import fields, replace

import numpy as np
import pytest

from prospect_mj.experiment.paper.measures.bootstrap import interval, times_drawn
from prospect_mj.experiment.paper.measures.curves import RunCounts
from prospect_mj.experiment.paper.measures.sample import Pair
from prospect_mj.experiment.paper.measures.statements import MEASURES
from prospect_mj.experiment.paper.reproduce_config import ReproduceConfig
from prospect_mj.experiment.populations.population import run_population
from prospect_mj.recording.recording import Recording

RUNS, STUDIES, RESAMPLES = 1000, 100, 500


def rows(counts, numbers):
    """Some of the runs: of what is counted, and of what is counted of a kind."""
    if isinstance(counts, np.ndarray):
        return counts[numbers]
    if isinstance(counts, int):
        return counts
    parts = {f.name: rows(getattr(counts, f.name), numbers) for f in fields(counts)}
    return replace(counts, **parts)


def covered(counts, truth, rng):
    """For each measure, whether the interval of one study covers the truth."""
    drawn = rng.integers(len(counts[0].actions), size=RUNS)
    study = [rows(one, drawn) for one in counts]
    once = Pair(*(one.mean() for one in study))
    many = Pair(*(one.drawn(times_drawn(RUNS, rng, RESAMPLES)) for one in study))
    intervals = [interval(m(once)[0], m(many)) for m in MEASURES]
    return [i.low <= t <= i.high for i, t in zip(intervals, truth, strict=True)]


@pytest.mark.slow
@pytest.mark.timeout(7200)
def test_intervals_of_judged_measures_cover_the_truth_about_as_often_as_they_say():
    config = ReproduceConfig(runs=8 * RUNS, seed=1)
    recording, rng = Recording.load(), np.random.default_rng(7)
    populations = (
        run_population(recording, scenario, config.main, jobs=2)
        for scenario in config.scenarios
    )
    counts = [RunCounts.of(population) for population in populations]
    truth = [m(Pair(*(one.mean() for one in counts)))[0] for m in MEASURES]
    shares = np.mean([covered(counts, truth, rng) for _ in range(STUDIES)], axis=0)
    found = dict(zip((m.name for m in MEASURES), shares.tolist(), strict=True))
    print(found)
    # Binomial: 95 of a hundred, standard deviation 2. What takes steps of ten trials
    # may always be inside, or be right in between two of them.
    assert min(found.values()) >= 0.85, found
