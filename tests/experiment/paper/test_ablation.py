from collections import defaultdict

import numpy as np
import pytest
from synthetic import pair

from prospect_mj.experiment.paper import ablation, report_ablation
from prospect_mj.experiment.paper.ablation import Row, Variant
from prospect_mj.experiment.paper.bands import Curves, Interval
from prospect_mj.experiment.paper.sample import Pair, Sample
from prospect_mj.experiment.paper.scenario import PopulationSettings

DEFAULT = PopulationSettings()


def curves(actions, unsolved, switch):
    none = np.zeros((1, 4, len(actions)))
    return Curves(np.array([actions]), np.array([unsolved]), none, none, switch)


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


@pytest.mark.parametrize(
    ("changes", "distance"),
    [
        ({"near": 780}, 2.0**2),
        ({"near": 520}, 2.0**2),
        ({"pretrained": 300}, 2.0**2),
        ({"peak": 5.4}, 1.0),
        ({"peak": 7.6}, 1.0),
        ({"cut_off": 0.4}, 2.0**2),
        ({"cut_off": 0.45, "near": 780}, 1.0 + 4.0),
    ],
)
def test_a_difference_counts_in_tenths_of_the_number_squared(changes, distance):
    np.testing.assert_allclose(ablation.distance(planted(**changes)), [distance])


def test_what_is_never_reached_counts_as_reached_at_the_end():
    never = ablation.distance(planted(near=2000))
    np.testing.assert_allclose(never, [(350 / 65) ** 2])
    never = ablation.distance(planted(pretrained=400))
    np.testing.assert_allclose(never, [(150 / 25) ** 2])


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


def row(choice, distance, is_default=False, near=650.0):
    measured = {name: Interval(near, near, near) for name in ablation.PUBLISHED}
    return Row(Variant("factor", choice, {}), is_default, measured, Interval(*distance))


ROWS = [
    row("a", (2.0, 1.5, 2.5), is_default=True),
    row("b", (1.0, 0.8, 1.6)),
    row("c", (9.0, 8.0, 10.0), near=np.inf),
]


def test_the_best_is_the_nearest_and_as_good_are_those_it_cant_be_told_from():
    assert ablation.best(ROWS).variant.choice == "b"
    assert [r.variant.choice for r in ablation.as_good(ROWS)] == ["a", "b"]


def test_the_report_says_which_choice_fits_and_marks_the_default():
    text = "\n".join(report_ablation.section(ROWS, 200))
    assert "*b* fits best, no better by its interval than a; the default is *a*" in text
    assert "| a (default) |" in text
    assert ">= 9.00 (8.00 to 10.00)" in text
    assert "never" in text


def test_a_row_is_measured_with_intervals_and_tabulated():
    sample = Sample.of(*pair(), np.random.default_rng(0))
    variant = ablation.variants()[0]
    measured = ablation.measure_row(variant, True, sample)
    assert measured.distance.low <= measured.distance.estimate <= measured.distance.high
    (plain,) = ablation.table([measured]).to_pylist()
    assert plain["factor"] == variant.factor
    assert plain["near_optimal"] == measured.measured["near_optimal"].estimate
    assert plain["distance_high"] == measured.distance.high
