"""The study goes on where it was stopped, and its tables hold what was measured."""

from collections import defaultdict
from dataclasses import replace
from itertools import product
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import small_study

from prospect_mj.agent.haptics import LEFT, RIGHT, n_haptic
from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.haptics.touch import BITS, CATEGORY, END
from prospect_mj.experiment.development.measures.measures import MEASURES
from prospect_mj.experiment.development.study import (
    abstract_rows,
    after,
    causal,
    haptic_rows,
    learners,
    measured,
    ready,
    study,
)
from prospect_mj.experiment.development.study.learning import Laboratory
from prospect_mj.experiment.development.study.settings import FELT_WORLDS, Extent
from prospect_mj.experiment.development.study.study import Study
from prospect_mj.experiment.development.study.tables import tables
from prospect_mj.experiment.populations import digests, store
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.experiment.run.learning_curve import BLOCK
from prospect_mj.recording.worlds import STANDARD

EXTENT = Extent(("learners", "worlds", "change"), ("standard", "noisy"), ("post",))
N_TOWARDS = 2 * (3 + 3 + 1) + 1
N_ROWS = 8 + N_TOWARDS + 2 * 3 + 8
SETTINGS = small_study.SETTINGS
_SPLITS = {measured.INSERTION, measured.GRASP}


@pytest.fixture(scope="module", autouse=True)
def small():
    """Few resamples, no controls; sources are read elsewhere."""
    with pytest.MonkeyPatch.context() as patch:
        small_study.resample_little(patch)
        patch.setattr(learners, "CONTROLS", {})
        patch.setattr(digests, "source_digest", lambda: "sources")
        yield


@pytest.fixture(scope="module")
def worlds():
    return small_study.recordings()


def opened(folder, worlds, tell=lambda line: None, extent=EXTENT):
    return Study(folder, SETTINGS, extent, worlds, 1, tell)


@pytest.fixture(scope="module")
def done(tmp_path_factory, worlds):
    """A folder, the results, and the lines that were told."""
    folder, lines = tmp_path_factory.mktemp("study"), []
    return folder, opened(folder, worlds, lines.append).results(), lines


@pytest.fixture
def learned(monkeypatch):
    """Counts the populations that learn."""
    found, run = [], store.run_population
    monkeypatch.setattr(store, "run_population", lambda *a: found.append(1) or run(*a))
    return found


def test_all_rows_are_there(done):
    _, results, lines = done
    assert len(results.learners) == 8
    assert [one.row.name for one in results.singles] == list(DEFAULTS)
    assert {one.row.rule for one in results.singles} == {"suppressed"}
    assert len(results.towards_abstract) == N_TOWARDS
    assert len(results.worlds) == 6
    assert len(results.change) == 8
    assert results.causal == []
    assert list(results.seconds) == list(EXTENT.parts)
    assert len(lines) == N_ROWS + len(EXTENT.parts)
    assert results.learning_seconds > 0


def test_worlds_and_changes_are_told_from_each_other(done):
    _, results, _ = done
    by_world = {(one.row.world, one.row.name): one for one in results.worlds}
    one, other = (by_world[world, "linear"] for world in EXTENT.worlds)
    assert one.measured.measured != other.measured.measured
    # A change makes what was right wrong: errors are more than exploration's.
    for one in results.change:
        assert list(one.measured.measured) == [
            each.name for each in after.MEASURES_AFTER
        ]
        assert one.measured.measured["easy_errors"].estimate > 0.2


def test_a_thing_of_the_abstract_task_is_all_that_is_changed(done):
    _, results, _ = done
    usual = {(one.row.name, one.row.rule): one.measured for one in results.learners}
    for one in results.towards_abstract:
        name, *thing = one.row.name.split(", one_hot")
        assert one.row.world == abstract_rows.MADE_UP or thing or "forget" in name
        assert one.runs == SETTINGS.fewer_runs
        same = usual[name.removesuffix(", forgetting"), one.row.rule]
        assert list(same.measured) == [
            name for name in one.measured if name not in _SPLITS
        ]
    # Who sees other pictures learns otherwise.
    rows = {(one.row.name, one.row.world): one for one in results.towards_abstract}
    one_hot = rows["linear, one_hot", "standard"].measured
    assert one_hot != rows["linear, one_hot", "made-up"].measured
    assert one_hot != rows["linear", "made-up"].measured


def test_tables_have_what_was_measured(done):
    _, results, _ = done
    made = tables(results)
    assert set(made) == {"abstract", "measured", "shares", "sequences", "looks"}
    rows = made["measured"].to_pylist()
    (found,) = [
        row
        for row in rows
        if (row["part"], row["name"], row["rule"], row["world"], row["measure"])
        == ("learners", "replay", "allowed", "standard", "dominance")
    ]
    (told,) = [
        one
        for one in results.learners
        if (one.row.name, one.row.rule) == ("replay", "allowed")
    ]
    assert found["estimate"] == told.findings.measured["dominance"].estimate
    assert found["runs"] == SETTINGS.runs
    orders = [row for row in rows if row["measure"] == "order"]
    formerly_easy = len(results.change)
    assert len(orders) == N_ROWS + formerly_easy
    assert all(0 <= row["estimate"] <= 1 for row in orders)


def test_shares_of_a_set_add_up_to_one(done):
    _, results, _ = done
    sums, trials = defaultdict(list), set()
    for row in tables(results)["shares"].to_pylist():
        names = ("part", "name", "rule", "world", "then", "trials", "trial")
        sums[tuple(row[name] for name in names)].append(row["share"])
        trials |= {row["trial"]} if row["part"] == "learners" else set()
    # NaN where a set has no trial of the kind.
    np.testing.assert_allclose(np.nan_to_num([*sums.values()], nan=0.25).sum(axis=1), 1)
    assert trials == set(range(0, 600, BLOCK))


def test_splits_are_told_of_the_learner_that_has_some(done):
    _, results, _ = done
    for one in [*results.worlds, *results.change]:
        splits = _SPLITS & set(one.measured.measured)
        assert bool(splits) == (
            one.row.name == "discovery" and one.row.part == "worlds"
        )


def test_the_same_again_learns_nothing_and_comes_to_the_same(done, worlds, learned):
    folder, results, _ = done
    lines = []
    again = opened(folder, worlds, lines.append)
    made = tables(again.results())
    assert learned == []
    assert list(again.unused()) == []
    assert sum(line.endswith("kept") for line in lines) == N_ROWS
    for name, table in tables(results).items():
        np.testing.assert_equal(made[name].to_pydict(), table.to_pydict())


def test_a_killed_study_goes_on_where_it_was(tmp_path, done, worlds, learned):
    def interrupt(line):
        if len(learned) == 5:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        opened(tmp_path, worlds, interrupt).results()
    made, expected = map(tables, (opened(tmp_path, worlds).results(), done[1]))
    assert len(learned) == N_ROWS
    measured_ = (found["measured"].to_pydict() for found in (made, expected))
    np.testing.assert_equal(*measured_)


def test_parts_share_what_is_the_same_in_both(done, worlds, learned, monkeypatch):
    folder, results, _ = done
    base = next(causal.single(SETTINGS))
    monkeypatch.setattr(causal, "rows", lambda settings: [base])
    found = opened(folder, worlds, extent=Extent(("causal",))).results()
    assert learned == []
    (row,) = found.causal
    world = next(one for one in results.worlds if one.row.name == "discovery")
    expected = world.measured.measured
    for measure in MEASURES:
        assert row.measured[measure.name].estimate == pytest.approx(
            expected[measure.name].estimate, nan_ok=True
        )


def test_what_nothing_asked_for_is_told(done, worlds):
    folder, *_ = done
    one = opened(folder, worlds, extent=Extent(("worlds",), ("noisy",)))
    one.results()
    assert len(one.unused()) == N_ROWS - 3


def test_a_world_with_categories_has_its_own_population(tmp_path, worlds, learned):
    standard = worlds.standard
    category = np.arange(len(standard.nodes.child)) % 2
    told = {
        BITS: RecordedWorld(standard),
        CATEGORY: RecordedWorld(standard, 2, category),
    }
    rows = haptic_rows.rows(SETTINGS, {STANDARD: {BITS: 0, CATEGORY: 2}})
    asked = [row for row in rows if row.name == "discovery"]
    assert [row.settings.learner.n_haptic for row in asked] == [3, n_haptic(2)]
    laboratory = Laboratory(tmp_path, worlds, 1, lambda line: None)
    made = [laboratory.learned(row, told[row.touch]) for row in asked * 2]
    assert len(learned) == 2
    assert (made[0].n_actions == made[2].n_actions).all()
    assert (made[0].n_actions != made[1].n_actions).any()
    assert laboratory.unused() == []


def test_what_learners_are_told_of_grasps_is_a_part_like_others(
    tmp_path, worlds, monkeypatch
):
    standard, asked = worlds.standard, []
    others = {jar: {2: "two", 3: "three"} for jar in (*FELT_WORLDS, "narrow-lid")}
    models = dict.fromkeys(FELT_WORLDS, "six")
    found = SimpleNamespace(models=models, others=others, tables={})
    monkeypatch.setattr(study.haptics, "run", lambda *a: asked.append(a) or found)
    end = np.arange(len(standard.nodes.child)) % 2
    told = {BITS: RecordedWorld(standard), END: RecordedWorld(standard, 2, end)}
    of = {
        "six": told,
        "two": {CATEGORY: RecordedWorld(standard, 2, end)},
        "three": {CATEGORY: RecordedWorld(standard, 3, end)},
    }
    monkeypatch.setattr(study.touch, "worlds", lambda recording, models: of[models])
    made = opened(tmp_path, worlds, extent=Extent(("haptics",))).results()
    ((folder, felt, haptic, *_),) = asked
    assert folder == tmp_path
    assert felt == {world: worlds.by_world[world] for world in FELT_WORLDS}
    assert (haptic.grasped, haptic.seed) == (0, 0)
    names = [(one.row.world, one.row.name, one.row.touch) for one in made.touches]
    assert names == list(product(FELT_WORLDS, haptic_rows.FEELING, told))
    assert {one.measured.runs for one in made.touches} == {SETTINGS.fewer_runs}
    numbers = [(one.row.world, one.row.settings.categories) for one in made.by_number]
    assert numbers == list(product(FELT_WORLDS, (2, 3)))
    rows = tables(made)["measured"].to_pylist()
    told = {BITS: 0, END: 2}
    expected = {(*name, told[name[-1]]) for name in names}
    expected |= {(world, "discovery", CATEGORY, number) for world, number in numbers}
    keys = "world", "name", "touch", "categories"
    assert {tuple(row[key] for key in keys) for row in rows} == expected


def test_recordings_without_grasps_are_told_before_anything_starts(worlds, monkeypatch):
    asked = []
    monkeypatch.setattr(ready, "grasps", asked.append)
    ready.check_ready(SETTINGS, Extent(("learners", "haptics")), worlds)
    assert asked == [worlds.by_world[world] for world in FELT_WORLDS]


def test_rivals_get_the_study_s_sizes(tmp_path, worlds, monkeypatch):
    asked = []
    monkeypatch.setattr(study.rivals, "run", lambda *given: asked.append(given))
    own = replace(worlds, path=Path("mine"), folder=Path("others"))
    made = opened(tmp_path, own, extent=Extent(("rivals",))).results()
    assert (made.recording, made.recordings) == (own.path, own.folder)
    ((_, _, rival, path, *_),) = asked
    assert path == own.path
    assert (rival.linear_runs, rival.deep_runs, rival.deep_trials) == (3, 2, 50)
    assert rival.live_presentations == 0
    assert rival.live_errors == ()


def test_a_row_is_measured_like_any_population(worlds):
    row = learners.rows(SETTINGS)[0]
    made = store.run_population(worlds.standard, row.scenario, row.settings)
    told = measured.told(row, made, np.random.default_rng(5))
    expected = Findings.of(made, np.random.default_rng(5))
    found = told.measured.measured
    np.testing.assert_equal(
        {name: found[name] for name in expected.measured}, dict(expected.measured)
    )
    # With fewer runs elsewhere the same single runs are told as the same numbers.
    shown = measured.measured(row, made, np.random.default_rng(5)).measured
    assert found.keys() == shown.measured.keys()
    assert shown.measured["other_optimal"] == found["other_optimal"]
    assert set(np.unique(made.lid)) == {LEFT, RIGHT}
