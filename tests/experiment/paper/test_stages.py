import numpy as np
import pytest
from synthetic import of_strategies, pair, sampled

from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.experiment.paper.measures import stages
from prospect_mj.experiment.populations.scenario import Scenario
from prospect_mj.experiment.populations.strategies import Strategy


def test_stages_are_the_beginning_the_height_of_corrections_and_the_end():
    trials = np.arange(1000)
    strategy = np.full((6, 1000), Strategy.OPTIMAL)
    strategy[:, (trials >= 400) & (trials < 600)] = Strategy.OTHER
    strategy[:, (trials >= 650) & (trials < 725)] = Strategy.LATE
    strategy[:, (trials >= 725) & (trials < 750)] = Strategy.EARLY
    lid = np.where((trials < 400) | (trials % 2 == 0), RIGHT, LEFT)
    dominant = of_strategies(strategy, lid, Scenario(1000, 400))
    baseline = pair(runs=6)[0]
    sample = sampled(baseline, dominant)
    first, height, last = stages.stages(sample)
    spans = [(stage.first, stage.last) for stage in (first, height, last)]
    assert spans == [(400, 499), (650, 749), (900, 999)]
    assert first.measured("optimal").estimate == 0
    assert first.measured("other").estimate == 1
    assert np.isnan(first.measured("preference").estimate)
    assert height.measured("late").estimate == pytest.approx(0.75, abs=0.03)
    assert height.measured("nonradial").estimate == 1
    assert height.measured("preference").estimate == pytest.approx(0.25, abs=0.03)
    assert last.measured("optimal") == last.measured("easy_optimal") == (1, 1, 1, 0)
    assert last.measured("easy_nonradial") == (0, 0, 0, 0)


def test_the_shortest_study_has_nothing_but_its_stages():
    sample = sampled(*pair(runs=5, trials=700))
    spans = [(stage.first, stage.last) for stage in stages.stages(sample)]
    assert spans == [(400, 499), (500, 599), (600, 699)]
