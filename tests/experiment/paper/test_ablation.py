from collections import defaultdict

import numpy as np
import pytest
from synthetic import pair, sampled

from prospect_mj.experiment.paper import ablation, report_ablation
from prospect_mj.experiment.paper.ablation import Row, Variant
from prospect_mj.experiment.paper.bands import Curves, Interval, interval
from prospect_mj.experiment.paper.sample import Pair
from prospect_mj.experiment.paper.scenario import PopulationSettings

DEFAULT = PopulationSettings()


def curves(actions, unsolved, switch):
    none = [np.zeros((1, n, len(actions))) for n in (4, 4, 2, 2)]
    return Curves(np.array([actions]), np.array([unsolved]), *none, switch)


def planted(cut_off=0.6, near=650, pretrained=250, peak=6.5):
    """Curves with the four numbers given."""
    trials = np.arange(0, 1000, 10)
    unsolved = np.where(trials == 0, cut_off, 0.0)
    baseline = np.where(trials < near, 5.0, 2.2)
    dominant = np.where(trials < pretrained, 5.0, 2.2)
    dominant[40:60] = peak
    return Pair(curves(baseline, unsolved, 0), curves(dominant, unsolved, 40))


def test_the_published_numbers_are_at_no_distance():
    assert ablation.distance(planted()) == [0]
    assert ablation.distance(planted(cut_off=1.0, peak=6.0)) == [0]
    assert ablation.distance(planted(near=710, pretrained=230)) == [0]


@pytest.mark.parametrize(
    ("changes", "distance"),
    [
        ({"near": 780}, 1.0),
        ({"near": 520}, 1.0),
        ({"pretrained": 300}, 1.0),
        ({"peak": 5.4}, 1.0),
        ({"peak": 7.6}, 1.0),
        ({"cut_off": 0.4}, 2.0**2),
        ({"cut_off": 0.45, "near": 850}, 1.0 + (135 / 65) ** 2),
    ],
)
def test_a_difference_counts_in_tenths_of_the_number_squared(changes, distance):
    np.testing.assert_allclose(ablation.distance(planted(**changes)), [distance])


def test_what_is_never_reached_counts_as_reached_at_the_end():
    never = ablation.distance(planted(near=2000))
    np.testing.assert_allclose(never, [(285 / 65) ** 2])
    never = ablation.distance(planted(pretrained=400))
    np.testing.assert_allclose(never, [(125 / 25) ** 2])


def test_each_factor_has_the_default_once_and_other_choices():
    factors = defaultdict(list)
    for variant in ablation.variants():
        factors[variant.factor].append(variant.settings(DEFAULT))
    assert len(factors) == 6
    for choices in factors.values():
        assert choices.count(DEFAULT) == 1
        assert len(set(map(repr, choices))) == len(choices) > 1


def test_a_variant_changes_what_it_names_and_nothing_else():
    size = PopulationSettings(runs=7, seed=3)
    changed = Variant("a", "b", {"supervisor": "safe"}).settings(size)
    assert changed == PopulationSettings(runs=7, seed=3, supervisor="safe")


COMMON = np.linspace(-3, 3, 101)
"""What chance adds in every resample to all choices alike."""


def row(choice, distance, own=0.0, is_default=False, measured=(650.0,) * 3):
    """A choice whose resampled distances share all chance but its own (101,)."""
    intervals = {name: Interval(*measured) for name in ablation.PUBLISHED}
    many = distance + COMMON + own
    variant = Variant("factor", choice, {})
    return Row(variant, is_default, intervals, interval(distance, many), many)


ALTERNATING = np.where(np.arange(101) % 2, 1.5, -1.5)
INF = np.inf
ROWS = [
    row("a", 12.0, own=ALTERNATING, is_default=True),
    row("b", 11.0),
    row("c", 12.0),
    row("d", 29.0, measured=(INF, INF, INF)),
    row("e", 29.0, measured=(650.0, 640.0, INF)),
]


def test_choices_are_told_apart_by_what_chance_they_do_not_share():
    assert ablation.best(ROWS).variant.choice == "b"
    # The intervals of b and c overlap; yet c is farther by 1 in every resample.
    assert ROWS[2].distance.low < ROWS[1].distance.high
    assert ablation.farther(ROWS[2], ROWS[1]) == (1, 1, 1, 0)
    assert ablation.farther(ROWS[0], ROWS[1]) == pytest.approx((1, -0.5, 2.5, 0))
    assert [r.variant.choice for r in ablation.as_good(ROWS)] == ["a", "b"]


def test_the_report_says_which_choice_fits_and_marks_the_default():
    text = "\n".join(report_ablation.section(ROWS, 200))
    assert "*b* fits best, not to be told from a; the default is *a*" in text
    assert "| a (default) |" in text
    assert "never" in text


def test_a_distance_with_something_never_reached_is_a_lower_bound():
    lines = "\n".join(report_ablation.section(ROWS, 200)).splitlines()
    d, e = (next(line for line in lines if f"| {name} |" in line) for name in "de")
    assert "| >= 29.00 (>= 26.12 to >= 31.88) |" in d
    assert "| 29.00 (26.12 to >= 31.88) |" in e


def test_a_row_is_measured_with_intervals_and_tabulated():
    sample = sampled(*pair())
    variant = ablation.variants()[0]
    measured = ablation.measure_row(variant, True, sample)
    assert measured.distance.low <= measured.distance.estimate <= measured.distance.high
    (plain,) = ablation.table([measured]).to_pylist()
    assert plain["factor"] == variant.factor
    assert plain["near_optimal"] == measured.measured["near_optimal"].estimate
    assert plain["distance_high"] == measured.distance.high


def test_the_table_tells_how_much_farther_a_choice_is_than_the_best():
    plain = {row["choice"]: row for row in ablation.table(ROWS).to_pylist()}
    assert [plain["b"][f"farther{part}"] for part in ("", "_low", "_high")] == [0, 0, 0]
    assert plain["c"]["farther_low"] == 1
    assert plain["a"]["farther_low"] == pytest.approx(-0.5)
