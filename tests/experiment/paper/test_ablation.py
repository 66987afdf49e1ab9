from collections import defaultdict
from dataclasses import replace

import numpy as np
import pytest
from ideal_recording import ideal, recording
from synthetic import pair, sampled

from prospect_mj.experiment.paper.ablation import ablation_table, choices
from prospect_mj.experiment.paper.ablation.choices import Row, Variant
from prospect_mj.experiment.paper.measures.bootstrap import Interval, interval
from prospect_mj.experiment.paper.measures.curves import Curves, OfKind
from prospect_mj.experiment.paper.measures.sample import Pair
from prospect_mj.experiment.paper.measures.statements import STATEMENTS, Judgement
from prospect_mj.experiment.paper.measures.target import Verdict
from prospect_mj.experiment.paper.report import report_ablation
from prospect_mj.experiment.paper.reproduce_config import ReproduceConfig
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.experiment.populations.scenario import PopulationSettings

DEFAULT = PopulationSettings()
MEASURED = [(said, measure) for said in STATEMENTS for measure in said.measures]
N = len(MEASURED)
HOLDS, FAILS, OPEN = Verdict.HOLDS, Verdict.FAILS, Verdict.OPEN


def curves(actions, unsolved, switch):
    taken = np.array([actions])
    of_kind = OfKind(taken, *(np.zeros((1, n, len(actions))) for n in (4, 2)))
    return Curves(taken, np.array([unsolved]), of_kind, of_kind, switch)


def planted(cut_off=0.6, near=650, pretrained=250, after=6.5):
    """Curves with the four numbers given."""
    trials = np.arange(0, 1000, 10)
    unsolved = np.where(trials == 0, cut_off, 0.0)
    baseline = np.where(trials < near, 5.0, 2.2)
    dominant = np.where(trials < pretrained, 5.0, 2.2)
    dominant[40:60] = after
    return Pair(curves(baseline, unsolved, 0), curves(dominant, unsolved, 40))


def test_the_published_numbers_are_at_no_distance():
    assert choices.distance(planted()) == [0]
    assert choices.distance(planted(cut_off=1.0, after=6.0)) == [0]
    assert choices.distance(planted(near=710, pretrained=230)) == [0]


@pytest.mark.parametrize(
    ("changes", "distance"),
    [
        ({"near": 780}, 1.0),
        ({"near": 520}, 1.0),
        ({"pretrained": 300}, 1.0),
        ({"after": 5.4}, 1.0),
        ({"after": 7.6}, 1.0),
        ({"cut_off": 0.4}, 2.0**2),
        ({"cut_off": 0.45, "near": 850}, 1.0 + (135 / 65) ** 2),
    ],
)
def test_a_difference_counts_in_tenths_of_the_number_squared(changes, distance):
    np.testing.assert_allclose(choices.distance(planted(**changes)), [distance])


def test_what_is_never_reached_counts_as_reached_at_the_end():
    never = choices.distance(planted(near=2000))
    np.testing.assert_allclose(never, [(285 / 65) ** 2])
    never = choices.distance(planted(pretrained=400))
    np.testing.assert_allclose(never, [(125 / 25) ** 2])


def test_what_a_short_study_could_not_reach_is_at_no_distance():
    short = planted(near=2000)
    assert choices.distance(replace_end(short, 56)) == [0]
    np.testing.assert_allclose(choices.distance(replace_end(short, 78)), [1.0])


def replace_end(pair, sets):
    """The same without what follows a number of sets in the first scenario."""
    shorter = {n: getattr(pair.baseline, n)[:, :sets] for n in ("actions", "unsolved")}
    return pair._replace(baseline=replace(pair.baseline, **shorter))


def test_each_factor_has_the_default_once_and_other_choices():
    factors = defaultdict(list)
    for variant in choices.variants():
        factors[variant.factor].append(variant.settings(DEFAULT))
    assert len(factors) == 6
    for of_it in factors.values():
        assert of_it.count(DEFAULT) == 1
        assert len(set(map(repr, of_it))) == len(of_it) > 1


def test_a_variant_changes_what_it_names_and_nothing_else():
    size = PopulationSettings(runs=7, seed=3)
    changed = Variant("a", "b", {"supervisor": "safe"}).settings(size)
    assert changed == PopulationSettings(runs=7, seed=3, supervisor="safe")


def test_no_run_of_the_ablation_is_one_of_the_main_study():
    shown = recording(left=(ideal,), right=(ideal,))
    config = ReproduceConfig(runs=20, ablation_runs=20)
    drawn = [
        {
            float(programme.run(number).trials.draws[0, 0, 0])
            for number in range(settings.runs)
        }
        for settings in (config.main, config.ablation)
        for programme in (Programme(shown, config.scenarios[0], settings),)
    ]
    assert len(set.union(*drawn)) == 40
    other = ReproduceConfig(seed=1)
    assert (
        other.ablation.seed != config.ablation.seed == ReproduceConfig().ablation.seed
    )


COMMON = np.linspace(-3, 3, 101)
"""What chance adds in every resample to all choices alike."""


def row(choice, distance, own=0.0, measured=(650.0,) * 3, verdicts=(HOLDS,) * N):
    """A choice whose resampled distances share all chance but its own (101,)."""
    judged = [
        Judgement(said, measure, Interval(*measured), verdict)
        for (said, measure), verdict in zip(MEASURED, verdicts, strict=True)
    ]
    many = distance + COMMON + own
    variant = Variant("factor", choice, {})
    return Row(variant, choice == "a", judged, interval(distance, many), many)


ALTERNATING = np.where(np.arange(101) % 2, 1.5, -1.5)
INF = np.inf
ROWS = [
    row("a", 12.0),
    row("b", 11.0, own=ALTERNATING, verdicts=(HOLDS,) * (N - 2) + (FAILS, OPEN)),
    row("c", 13.0),
    row("d", 29.0, measured=(INF, INF, INF)),
    row("e", 29.0, measured=(650.0, 640.0, INF)),
    row("f", 12.0),
]
NEARER = row("g", 11.5)


def names(rows):
    return [row.variant.choice for row in rows]


def test_choices_are_told_apart_by_what_chance_they_do_not_share():
    # The intervals of a and c overlap; yet c is farther by 1 in every resample.
    assert ROWS[2].distance.low < ROWS[0].distance.high
    assert choices.farther(ROWS[2], ROWS[0]) == (1, 1, 1, 0)
    assert choices.farther(ROWS[1], ROWS[0]) == pytest.approx((-1, -2.5, 0.5, 0))
    assert names(choices.as_good(ROWS)) == ["b", "f"]
    assert choices.nearer(ROWS) == []
    assert names(choices.nearer([*ROWS, NEARER])) == ["g"]
    assert names(choices.as_good([*ROWS, NEARER])) == ["b", "f"]


def report(rows):
    return "\n".join(report_ablation.section(rows, 200))


def test_the_report_says_which_choices_are_as_good_as_the_default():
    text = report(ROWS)
    assert "- factor: *a* is the default; as good: *b*; *f*; " in text
    assert "smallest distance: *b*, 11.00." in text
    assert "never" in text
    assert "as good: no other; " in report([ROWS[0], ROWS[2]])


def test_the_default_is_told_once_of_all_things_left_open():
    again = [replace(row, variant=replace(row.variant, factor="other")) for row in ROWS]
    text = report([*ROWS, *again])
    assert text.count("| **the default** |") == 1
    assert "| a |" not in text
    assert text.count("| b |") == 2


def test_the_report_says_whether_the_default_stands():
    assert "None is nearer." in report(ROWS)
    doubted = report([*ROWS, NEARER])
    assert "None is nearer." not in doubted
    assert "Nearer than the default: factor *g*." in doubted


def test_the_report_tells_which_statements_hang_on_a_choice():
    lines = report(ROWS).splitlines()[-N:]
    assert all("| **holds** | 2 of 2 |  |" in line for line in lines[:-2])
    assert lines[-2].endswith("| 1 of 2 | does not hold with factor *b* |")
    assert lines[-1].endswith("| 1 of 2 | undecided with factor *b* |")
    marked = ["(fitted)" in line for line in lines]
    assert marked == [said.fitted for said, _ in MEASURED]


def test_a_distance_with_something_never_reached_is_a_lower_bound():
    lines = report(ROWS).splitlines()
    d, e = (next(line for line in lines if f"| {name} |" in line) for name in "de")
    assert "| >= 29.00 (>= 26.12 to >= 31.88) |" in d
    assert "| 29.00 (26.12 to >= 31.88) |" in e


def test_a_row_is_measured_with_intervals_and_tabulated():
    sample = sampled(*pair())
    variant = choices.variants()[0]
    measured = choices.measure_row(variant, True, sample)
    assert measured.distance.low <= measured.distance.estimate <= measured.distance.high
    assert len(measured.fitted) == 4
    (plain,) = ablation_table.table([measured]).to_pylist()
    assert plain["factor"] == variant.factor
    for judged in measured.judgements:
        name = judged.measure.name
        np.testing.assert_equal(plain[name], judged.measured.estimate)
        assert plain[f"{name}_verdict"] == judged.verdict
    assert plain["distance_high"] == measured.distance.high


def test_the_table_tells_how_much_farther_a_choice_is_than_the_default():
    plain = {row["choice"]: row for row in ablation_table.table(ROWS).to_pylist()}
    assert [plain["a"][f"farther{part}"] for part in ("", "_low", "_high")] == [0, 0, 0]
    assert plain["c"]["farther_low"] == 1
    assert plain["b"]["farther_low"] == pytest.approx(-2.5)
