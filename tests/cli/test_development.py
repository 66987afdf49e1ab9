"""The command that studies development: what it tells, writes, and refuses."""

import json
from dataclasses import replace

import pyarrow.parquet as pq
import pytest
import small_study

from prospect_mj import paths
from prospect_mj.cli import development as command
from prospect_mj.errors import MissingPackage
from prospect_mj.experiment.development import development
from prospect_mj.experiment.development.study import learners, ready
from prospect_mj.experiment.development.study.recordings import Recordings
from prospect_mj.experiment.development.study.settings import IMAGE_WORLDS
from prospect_mj.experiment.populations import digests, store
from prospect_mj.locking import LockedFolder
from prospect_mj.recording import shipped
from prospect_mj.recording.key import RecordingKey

SIZES = ("--runs", "3", "--setting-runs", "2", "--grasped", "0", "--planned", "0")
USUAL = (*SIZES, "--jobs", "1", "--parts", "learners", "worlds", "--out", "out")


@pytest.fixture(autouse=True)
def small(tmp_path, monkeypatch):
    """Where the command is; few learners and resamples, and nothing drawn."""
    monkeypatch.chdir(tmp_path)
    small_study.resample_little(monkeypatch)
    monkeypatch.setattr(learners, "CONTROLS", {})
    monkeypatch.setattr(digests, "source_digest", lambda: "sources")
    monkeypatch.setattr(development.pictures, "pictures", lambda *given: ())


@pytest.fixture
def made(monkeypatch):
    """In place of recordings from files."""
    by_world = {
        world: replace(one, key=RecordingKey.present(one.key.config))
        for world, one in small_study.recordings().by_world.items()
    }

    def load(worlds, *folders):
        return Recordings({world: by_world[world] for world in worlds})

    monkeypatch.setattr(Recordings, "load", load)
    return by_world


def test_it_writes_a_report_and_the_same_again_learns_nothing(
    tmp_path, made, capsys, monkeypatch
):
    assert command.main(USUAL) == 0
    said = capsys.readouterr()
    *lines, last = said.out.splitlines()
    assert last == "wrote out/report.md"
    assert said.err == ""
    # Four learners under two rules, what of them has an abstract task's things, the
    # three learners that see in each world, and the end of both parts.
    assert len(lines) == 8 + 15 + 3 * len(IMAGE_WORLDS) + 2
    assert lines[0].startswith("learners: linear, allowed: 3 runs, ")
    report = (tmp_path / "out" / "report.md").read_text()
    assert "## Worlds that look unlike each other" in report
    for name in ("measured", "shares", "sequences", "looks"):
        assert pq.read_table(tmp_path / "out" / "tables" / f"{name}.parquet").num_rows
    monkeypatch.setattr(store, "run_population", None)
    assert command.main(USUAL) == 0
    again = (tmp_path / "out" / "report.md").read_text()
    before_times = "## How it was made"
    assert again.partition(before_times)[0] == report.partition(before_times)[0]


def test_for_programs_it_is_one_object(made, capsys):
    assert command.main([*USUAL, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["report"] == "out/report.md"
    rows = {(row["name"], row["rule"]) for row in found["measured"]}
    assert ("replay", "allowed") in rows


def test_a_folder_of_another_study_is_refused_and_left_as_it_is(tmp_path, made, capsys):
    assert command.main(USUAL) == 0
    capsys.readouterr()
    before = (tmp_path / "out" / "development.yaml").read_bytes()
    more = [*USUAL, "--runs", "4"]
    assert command.main(more) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line == (
        "error: out holds another development (runs: 3, not 4); choose another folder"
    )
    assert (tmp_path / "out" / "development.yaml").read_bytes() == before
    with LockedFolder(tmp_path / "out"):
        assert command.main(USUAL) == 2
    assert "in use by another process" in capsys.readouterr().err


def test_other_parts_may_be_added_later(tmp_path, made):
    assert command.main(USUAL) == 0
    later = [*SIZES, "--parts", "change", "--changes", "post", "--out", "out"]
    assert command.main(later) == 0
    report = (tmp_path / "out" / "report.md").read_text()
    assert "## A world that changes" in report
    assert "`learners`, from which the answer follows, was left out" in report


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ("--runs 0", "runs is 0"),
        ("--runs -3", "runs is -3"),
        ("--runs 1000000000", "runs is 1000000000"),
        ("--runs many", "many"),
        ("--setting-runs 1", "1"),
        ("--jobs 0", "jobs is 0"),
        ("--seed -1", "seed is -1"),
        ("--deep-trials 3", "3"),
        ("--grasped 7", "grasped is 7"),
        ("--planned 3", "planned is 3"),
        ("--parts learners dance", "--parts is 'dance'; valid: learners, causal"),
        ("--parts learners learners", "parts"),
        ("--worlds moon", "--worlds is 'moon'; valid: standard, lamp-right"),
        ("--changes noisy", "--changes is 'noisy'; valid: post, lamp-right"),
        ("--recording nowhere", "nowhere"),
        ("--recordings nowhere", "nowhere has no recording of world lamp-right"),
        ("--parts worlds --recordings full", "full has no recording of world lamp-r"),
        ("--parts learners --recording full", "not a recording"),
        ("--parts learners --out full", "full is not empty"),
        ("--parts learners --out file", "not a folder"),
    ],
)
def test_bad_input_is_one_line(existing, refused, options, words):
    assert words in refused(lambda: command.main(options.split()))


def test_a_world_that_was_not_recorded_is_refused(refused, monkeypatch):
    monkeypatch.setattr(shipped, "worlds", lambda: ("standard",))
    line = refused(lambda: command.main(["--parts", "worlds"]))
    assert "no recording of world lamp-right comes with the package" in line


def test_one_that_lacks_the_variation_is_refused(existing, refused):
    folder = existing / "others"
    folder.mkdir()
    (folder / "post").symlink_to(paths.RECORDINGS / "standard")
    options = ["--parts", "change", "--changes", "post", "--recordings", "others"]
    line = refused(lambda: command.main(options))
    assert "others/post holds a recording of world standard, not post" in line


def test_a_machine_that_lacks_what_a_part_needs_is_told_at_once(
    made, monkeypatch, capsys, tmp_path
):
    def missing():
        raise MissingPackage("torch", "rivals")

    monkeypatch.setattr(ready, "check_installed", missing)
    assert command.main([*SIZES, "--parts", "learners", "rivals"]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert "torch" in line
    assert not list(tmp_path.iterdir())
