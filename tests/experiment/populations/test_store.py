import json
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pyarrow.compute as pc
import pyarrow.parquet as pq
import pytest
from ideal_recording import ideal, recording

from prospect_mj import paths
from prospect_mj.agent.learners import NAMES
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.populations import digests, store
from prospect_mj.experiment.populations.digests import recording_digest
from prospect_mj.experiment.populations.population import run_population
from prospect_mj.experiment.populations.scenario import (
    PopulationSettings,
    Scenario,
)
from prospect_mj.experiment.populations.store import Store

SCENARIO, SETTINGS = Scenario(30, 10), PopulationSettings(runs=3)
PACKAGE = Path(paths.__file__).parent


@pytest.fixture(scope="module")
def shown():
    return recording(left=(ideal,), right=(ideal,))


@pytest.fixture
def learned(monkeypatch):
    """Populations that really learned, in order."""
    seen = []

    def run(recording, scenario, settings, *others):
        seen.append((scenario, settings))
        return run_population(recording, scenario, settings, *others)

    monkeypatch.setattr(store, "run_population", run)
    return seen


def same(first, second):
    return first.scenario == second.scenario and all(
        np.array_equal(getattr(first, name), getattr(second, name))
        and getattr(first, name).dtype == getattr(second, name).dtype
        for name in ("lid", "n_actions", "solved", "strategy", "first_hand", "splits")
    )


def test_a_population_learns_once_and_is_read_the_same(tmp_path, shown, learned):
    first = Store(tmp_path, shown, 1).get(SCENARIO, SETTINGS)
    again = Store(tmp_path, shown, 2).get(SCENARIO, SETTINGS)
    assert same(first.population, again.population)
    assert same(first.population, run_population(shown, SCENARIO, SETTINGS))
    assert again.seconds == pytest.approx(first.seconds)
    assert again.seconds > 0
    assert again.jobs == first.jobs == 1
    assert len(learned) == 1
    assert len(list(tmp_path.iterdir())) == 1


def test_another_scenario_setting_recording_or_learner_is_another_population(
    tmp_path, shown, learned, monkeypatch
):
    kept = Store(tmp_path, shown, 1)
    kept.get(SCENARIO, SETTINGS)
    kept.get(Scenario(30), SETTINGS)
    kept.get(SCENARIO, replace(SETTINGS, seed=1))
    Store(tmp_path, recording(left=(ideal,), right=(ideal, ideal)), 1).get(
        SCENARIO, SETTINGS
    )
    monkeypatch.setattr(digests, "source_digest", lambda: "edited")
    Store(tmp_path, shown, 1).get(SCENARIO, SETTINGS)
    assert len(learned) == 5
    assert len(list(tmp_path.glob("*.parquet"))) == 5


def append(path, text):
    with path.open("a", encoding="utf-8") as file:
        file.write(text)


@pytest.mark.parametrize("learner", NAMES)
def test_a_change_of_any_code_that_decides_is_another_population(
    tmp_path, monkeypatch, learner
):
    for below in ("source_digest", "learner_digest"):
        monkeypatch.setattr(digests, below, lambda *names: "the same")
    files = digests.code_files(learner)
    shared = set(files).intersection(*map(digests.code_files, NAMES))
    assert f"experiment/populations/kernels/{learner}.py" in files
    for name in files:
        copy = tmp_path / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text((PACKAGE / name).read_text("utf-8"), "utf-8")
    before = digests.code(learner)
    assert digests.code(learner, tmp_path) == before
    for name in files:
        append(tmp_path / name, "# A comment decides nothing.\n")
    assert digests.code(learner, tmp_path) == before
    seen = {before}
    for name in set(files) - (shared if learner != "linear" else set()):
        append(tmp_path / name, "CHANGED = 1\n")
        after = digests.code(learner, tmp_path)
        assert after not in seen
        seen.add(after)


def test_what_is_below_the_populations_decides_too(monkeypatch):
    seen = {digests.code(learner) for learner in NAMES}
    for below in ("source_digest", "learner_digest"):
        monkeypatch.setattr(digests, below, lambda *names: "edited")
        seen |= {digests.code(learner) for learner in NAMES}
    assert len(seen) == 3 * len(NAMES)


def test_code_of_a_learner_is_all_that_its_population_imports():
    """Of the folder, beside what only looks at populations, or keeps them."""
    here = "experiment/populations"
    apart = {"cache", "__init__", "twin", "twins", "remembered"}
    apart |= {"plain", "optimum", "speed", "store", "digests", "costs"}
    found = {
        path.relative_to(PACKAGE).as_posix()
        for path in (PACKAGE / here).rglob("*.py")
        if path.stem not in apart
    }
    files = {name for learner in NAMES for name in digests.code_files(learner)}
    assert found == {name for name in files if name.startswith(here)}


@pytest.mark.parametrize("package", ["numpy", "numba"])
def test_other_versions_make_another_population(tmp_path, shown, monkeypatch, package):
    Store(tmp_path, shown, 1).get(SCENARIO, SETTINGS)
    versions = store.installed_versions(store.PACKAGES)
    assert package in versions
    changed = versions | {package: "0.0"}
    monkeypatch.setattr(store, "installed_versions", lambda packages: changed)
    Store(tmp_path, shown, 1).get(SCENARIO, SETTINGS)
    assert len(list(tmp_path.iterdir())) == 2


def test_a_file_in_place_of_the_folder_is_told(tmp_path, shown):
    (tmp_path / "populations").touch()
    with pytest.raises(RunFolderError, match="populations is not a folder"):
        Store(tmp_path / "populations", shown, 1)


def test_a_file_says_what_it_is_of_and_is_named_for_it(tmp_path, shown):
    kept = Store(tmp_path, shown, 1)
    settings = replace(SETTINGS, supervisor="safe", shaping=("grasp-left:5",))
    kept.get(SCENARIO, settings)
    kept.get(Scenario(30), SETTINGS)
    names = sorted(path.name.partition("-")[0] for path in tmp_path.iterdir())
    assert names == ["baseline", "dominant"]
    (file,) = tmp_path.glob("dominant-*.parquet")
    table = pq.read_table(file)
    notes = {
        name: json.loads(table.schema.metadata[name.encode()])
        for name in ("scenario", "settings", "recording", "code", "versions")
    }
    assert Scenario(**notes["scenario"]) == SCENARIO
    assert notes["settings"] == json.loads(json.dumps(asdict(settings)))
    assert notes["recording"] == recording_digest(shown)
    assert notes["versions"].keys() == {"numpy", "numba"}
    # All that it takes to see what learner 1 did in its trials.
    mine = table.filter(pc.field("run") == 1)
    found = run_population(shown, SCENARIO, settings).n_actions[1]
    assert mine["n_actions"].to_pylist() == found.tolist()


def test_files_that_were_not_asked_for_are_unused(tmp_path, shown, monkeypatch):
    first = Store(tmp_path, shown, 1)
    first.get(SCENARIO, SETTINGS)
    assert first.unused() == []
    (old,) = tmp_path.iterdir()
    monkeypatch.setattr(digests, "source_digest", lambda: "edited")
    second = Store(tmp_path, shown, 1)
    second.get(SCENARIO, SETTINGS)
    assert second.unused() == [old]
    second.get(SCENARIO, SETTINGS)
    assert second.unused() == [old]


def population_file(folder):
    (file,) = folder.glob("*.parquet")
    return file


@pytest.mark.parametrize("content", [b"", b"PAR1 and no more"])
def test_a_damaged_file_is_refused_and_left_as_it_is(tmp_path, shown, learned, content):
    Store(tmp_path, shown, 1).get(SCENARIO, SETTINGS)
    file = population_file(tmp_path)
    file.write_bytes(content)
    with pytest.raises(RunFolderError, match=f"{file.name} can't be read"):
        Store(tmp_path, shown, 1).get(SCENARIO, SETTINGS)
    assert file.read_bytes() == content
    assert len(learned) == 1


def test_a_file_of_another_population_is_refused(tmp_path, shown):
    for seed in range(2):
        part = Store(tmp_path / str(seed), shown, 1)
        part.get(SCENARIO, replace(SETTINGS, seed=seed))
    target = population_file(tmp_path / "0")
    target.write_bytes(population_file(tmp_path / "1").read_bytes())
    with pytest.raises(RunFolderError, match="from another study"):
        Store(tmp_path / "0", shown, 1).get(SCENARIO, SETTINGS)


def test_the_digest_sees_a_single_outcome(shown):
    child = shown.nodes.child.copy()
    child[0, 0] = child[0, 1]
    changed = replace(shown, nodes=replace(shown.nodes, child=child))
    assert recording_digest(changed) != recording_digest(shown)
    assert recording_digest(shown) == recording_digest(replace(shown))
