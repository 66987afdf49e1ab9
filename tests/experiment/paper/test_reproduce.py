import re
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest
from ideal_recording import ideal, recording

from prospect_mj import tables
from prospect_mj.cli import reproduce as command
from prospect_mj.errors import InvalidValue, RunFolderError
from prospect_mj.experiment.paper import ablation, live_check, store
from prospect_mj.experiment.paper.live_check import FoundRuns
from prospect_mj.experiment.paper.reproduce import n_steps, reproduce
from prospect_mj.experiment.paper.reproduce_config import ReproduceConfig
from prospect_mj.experiment.paper.sample import title
from prospect_mj.experiment.paper.statements import STATEMENTS
from prospect_mj.locking import LockedFolder
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.schema import SCHEMA

CONFIG = ReproduceConfig(runs=3, trials=430, ablation_runs=2)
FIGURES = ("figure_5a", "figure_5b", "figure_6a", "figure_6b")


@pytest.fixture(scope="module")
def shown():
    return recording(left=(ideal, ideal), right=(ideal, ideal))


@pytest.fixture(scope="module", autouse=True)
def few_variants():
    """Two choices are enough to see the table; sources are read elsewhere."""
    with pytest.MonkeyPatch.context() as patch:
        both = [
            v for v in ablation.variants() if v.factor == "bootstrapping at the cap"
        ]
        patch.setattr(ablation, "variants", lambda: both)
        patch.setattr(store, "source_digest", lambda: "sources")
        patch.setattr(RecordingKey, "differences", lambda *keys: ["physics changed"])
        yield


@pytest.fixture(scope="module", autouse=True)
def live():
    """Two live runs that were found, so that none of 430 trials has to be made."""
    found = FoundRuns(np.random.default_rng(0).integers(2, 11, (2, 430)), 1)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(live_check, "read_live", lambda *given: found)
        yield Path("live")


@pytest.fixture(scope="module")
def done(tmp_path_factory, shown, live):
    out = tmp_path_factory.mktemp("reproduction")
    ticks = []
    reproduce(shown, CONFIG, out, 1, live, lambda: ticks.append(1))
    assert len(ticks) == n_steps() == 6
    return out


def without_times(report):
    return report.read_text("utf-8").partition("## Speed")[0]


def test_everything_is_written_and_linked(done):
    report = (done / "report.md").read_text("utf-8")
    for name in (*FIGURES, "live"):
        assert f"]({name}.png)" in report
        assert (done / f"{name}.png").read_bytes().startswith(b"\x89PNG")
        assert pq.ParquetFile(done / f"{name}.parquet").metadata.num_rows > 0
    linked = re.findall(r"\]\(([^)]*)\)", report)
    assert all((done / link).is_file() for link in linked)
    rows = pq.ParquetFile(done / "statements.parquet").read()
    assert rows.num_rows == len(STATEMENTS)
    assert pq.ParquetFile(done / "ablation.parquet").metadata.num_rows == 2
    assert not [file for file in done.rglob("*") if file.name.startswith(".")]


def test_the_report_tells_every_statement_with_its_verdict(done, shown):
    report = (done / "report.md").read_text("utf-8")
    for statement in STATEMENTS:
        (line,) = {
            line
            for line in report.splitlines()
            if line.startswith(f"| {statement.text} | {statement.target.words} | ")
            and f" | {title(statement.measure)}: " in line
        }
        assert re.search(r"\*\*(holds|does not hold|undecided)\*\* \|$", line)
    assert "2 presentations with the lid to the left and 2" in report
    assert "best possible mean is 2.000" in report
    assert "430 trials per run" in report
    assert f"key {shown.key.digest[:16]}, seed 0, harmonic gross motion" in report
    assert "Since then: physics changed." in report
    assert "2 runs on live physics (1 unfinished ones left out)" in report


def test_a_killed_reproduction_goes_on_where_it_was(
    tmp_path, shown, done, live, monkeypatch
):
    def interrupt():
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        reproduce(shown, CONFIG, tmp_path, 1, live, interrupt)
    assert not (tmp_path / "report.md").exists()
    learned, run = [], store.run_population
    monkeypatch.setattr(
        store, "run_population", lambda *args: learned.append(1) or run(*args)
    )
    reproduce(shown, CONFIG, tmp_path, 1, live)
    # Of six the first was kept, and the default's in the ablation is one of another.
    assert len(learned) == 5
    assert without_times(tmp_path / "report.md") == without_times(done / "report.md")
    for name in FIGURES:
        one, other = (folder / f"{name}.parquet" for folder in (tmp_path, done))
        assert one.read_bytes() == other.read_bytes()


def test_a_finished_one_learns_nothing_anew_and_may_get_live_runs(
    tmp_path, shown, done, monkeypatch
):
    shutil.copytree(done, tmp_path / "copy")
    monkeypatch.setattr(store, "run_population", None)
    reproduce(shown, CONFIG, tmp_path / "copy", 1)
    assert "no live runs were given" in (tmp_path / "copy" / "report.md").read_text()


def test_other_folders_are_refused_and_left_as_they_are(tmp_path, shown, done):
    (tmp_path / "thesis.tex").touch()
    with pytest.raises(RunFolderError, match="not empty"):
        reproduce(shown, CONFIG, tmp_path, 1)
    with pytest.raises(RunFolderError, match="not a folder"):
        reproduce(shown, CONFIG, tmp_path / "thesis.tex", 1)
    assert [file.name for file in tmp_path.iterdir()] == ["thesis.tex"]
    with pytest.raises(RunFolderError, match="its config differs"):
        reproduce(shown, replace(CONFIG, runs=4), done, 1)
    other = recording(left=(ideal,), right=(ideal,))
    with pytest.raises(RunFolderError, match="its recording differs"):
        reproduce(other, CONFIG, done, 1)


@pytest.mark.parametrize("part", [0, 0.2, 0.5, 0.9, 1 - 1e-6])
def test_a_half_written_key_is_damaged_however_much_there_is(
    tmp_path, shown, done, part
):
    whole = (done / "reproduction.yaml").read_text()
    (tmp_path / "reproduction.yaml").write_text(whole[: int(part * len(whole))])
    with pytest.raises(RunFolderError, match="can't be read: it is damaged"):
        reproduce(shown, CONFIG, tmp_path, 1)


def test_a_file_in_place_of_the_populations_is_told(tmp_path, shown, done):
    shutil.copytree(done, tmp_path / "copy")
    shutil.rmtree(tmp_path / "copy" / "populations")
    (tmp_path / "copy" / "populations").touch()
    with pytest.raises(RunFolderError, match="populations can't be made"):
        reproduce(shown, CONFIG, tmp_path / "copy", 1)


def test_jobs_are_told_as_they_were_when_it_was_learned(tmp_path, shown, done):
    shutil.copytree(done, tmp_path / "copy")
    reproduce(shown, CONFIG, tmp_path / "copy", 7)
    report = (tmp_path / "copy" / "report.md").read_text()
    assert "(threads: 1)" in report


def test_equal_choices_have_equal_intervals(done, shown, monkeypatch, tmp_path):
    default = ablation.variants()[0]
    twice = [replace(default, factor=name) for name in ("one", "other")]
    monkeypatch.setattr(ablation, "variants", lambda: twice)
    shutil.copytree(done, tmp_path / "copy")
    reproduce(shown, CONFIG, tmp_path / "copy", 1)
    rows = pq.ParquetFile(tmp_path / "copy" / "ablation.parquet").read().to_pylist()
    first, second = ({**row, "factor": ""} for row in rows)
    assert first == second


@pytest.mark.parametrize(
    "sizes",
    [
        {"runs": 0},
        {"runs": 1},
        {"runs": -5},
        {"runs": 10**9},
        {"trials": 0},
        {"trials": -1},
        {"trials": 429},
        {"trials": 10**9},
        {"ablation_runs": 0},
        {"runs": 10_000, "trials": 2000},
        {"runs": 10_001, "trials": 500},
        {"trials": 10_001},
        {"seed": -1},
    ],
    ids=str,
)
def test_sizes_that_make_no_experiment_are_refused(sizes):
    with pytest.raises(InvalidValue):
        ReproduceConfig(**sizes)


@pytest.fixture
def broken(tmp_path, shown):
    """A folder with recordings that can't be used."""
    for name in ("empty", "half", "foreign"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "recording.yaml").write_bytes(shown.key.as_yaml())
    whole = tables.parquet(SCHEMA.empty_table(), shown.key.digest)
    (tmp_path / "half" / "left-0000.parquet").write_bytes(whole[: len(whole) // 2])
    foreign = tables.parquet(SCHEMA.empty_table(), "another digest")
    (tmp_path / "foreign" / "left-0000.parquet").write_bytes(foreign)
    return tmp_path


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ("--runs 0", "runs is 0"),
        ("--trials -1", "trials is -1"),
        ("--trials 12", "expected an integer from 430"),
        ("--jobs 0", "jobs is 0"),
        ("--recording nowhere", "not a recording"),
        ("--recording empty", "without any tree"),
        ("--recording half", "damaged"),
        ("--recording foreign", "from another recording"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(
    broken, monkeypatch, capsys, options, message
):
    monkeypatch.chdir(broken)
    assert command.main([*options.split(), "--out", "out"]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("error: ")
    assert message in line
    assert not (broken / "out").exists()


def test_the_command_writes_the_report_and_nothing_but_its_path(
    tmp_path, shown, monkeypatch, capsys
):
    monkeypatch.setattr(Recording, "load", lambda path: shown)
    monkeypatch.setattr(Recording, "warn_if_foreign", lambda recording: None)
    sizes = "--runs 2 --trials 430 --ablation-runs 2 --jobs 1"
    out = tmp_path / "out"
    assert command.main([*sizes.split(), "--out", str(out)]) == 0
    said = capsys.readouterr()
    assert said.out == f"wrote {out / 'report.md'}\n"
    assert said.err == ""
    # Another process at work there is an error, too.
    with LockedFolder(out):
        assert command.main([*sizes.split(), "--out", str(out)]) == 2
    assert "in use by another process" in capsys.readouterr().err
