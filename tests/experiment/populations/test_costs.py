"""What learners cost: the sizes by hand, and the table."""

import pytest
from ideal_recording import ideal, recording

from prospect_mj.agent import (
    LinearSettings,
    ReplaySettings,
    TableSettings,
    new_learner,
)
from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.populations.costs import (
    Cost,
    measured_costs,
    n_bytes,
    table,
)


def test_bytes_are_those_of_all_arrays():
    # 6 x 303 weights of eight bytes, and a count.
    assert n_bytes(new_learner(LinearSettings())) == 6 * 303 * 8 + 8
    # 2 x 3 x 6 values, two orientations seen or not, and a count.
    assert n_bytes(new_learner(TableSettings())) == 36 * 8 + 2 + 8


def test_what_is_remembered_counts_too():
    good = recording(left=(ideal,), right=(ideal,))
    buffer = 50
    few = (LinearSettings(), ReplaySettings(buffer=buffer, replays=1))
    linear, replay = measured_costs(good, few, runs=1)
    # Two states of 303 numbers, action, reward, end, and what was allowed.
    step = (2 * 303 + 2) * 8 + 1 + 6
    assert replay.n_bytes == linear.n_bytes + 8 + buffer * step
    assert linear.seconds > 0
    assert 0 < linear.action < linear.plain_action


def test_every_learner_is_in_the_benchmark_the_linear_one_first():
    names = [settings.name for settings in DEFAULTS.values()]
    assert names == ["linear", "replay", "table", "discovery"]


def test_numbers_stand_beside_their_ratio_to_the_first():
    costs = [Cost("a", 0.004, 1e-6, 1e-4, 2000), Cost("b", 0.01, 2e-6, 1e-3, 1000)]
    lines = [line.split("  ") for line in table(costs).splitlines()]
    cells = [[cell.strip() for cell in line if cell.strip()] for line in lines]
    assert cells[1] == ["a", "4 (x 1)", "1 (x 1)", "100 (x 1)", "2 (x 1)"]
    assert cells[2] == ["b", "10 (x 2.5)", "2 (x 2)", "1000 (x 10)", "1 (x 0.5)"]


@pytest.mark.parametrize("name", ["seconds", "action", "plain_action", "n_bytes"])
def test_every_number_is_in_the_table(name):
    cost = Cost("a", 1.0, 1.0, 1.0, 1)
    twice = cost._replace(**{name: 2})
    assert "(x 2)" in table([cost, twice])
