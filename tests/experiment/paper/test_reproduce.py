import re
import shutil
from dataclasses import replace

import numpy as np
import pyarrow.parquet as pq
import pytest
from ideal_recording import ideal, recording
from live_by_hand import live_run, live_runs

from prospect_mj import tables
from prospect_mj.cli import reproduce as command
from prospect_mj.errors import InvalidValue, RunFolderError
from prospect_mj.experiment.paper import reproduce as driver
from prospect_mj.experiment.paper.ablation import choices
from prospect_mj.experiment.paper.figures import pictures
from prospect_mj.experiment.paper.measures.statements import STATEMENTS
from prospect_mj.experiment.paper.measures.target import Verdict
from prospect_mj.experiment.paper.reproduce import n_steps, reproduce
from prospect_mj.experiment.paper.reproduce_config import ReproduceConfig
from prospect_mj.experiment.populations import digests, store
from prospect_mj.experiment.populations.population import run_population
from prospect_mj.experiment.populations.scenario import (
    PopulationSettings,
    Scenario,
)
from prospect_mj.experiment.populations.speed import Speed
from prospect_mj.locking import LockedFolder
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.schema import SCHEMA

CONFIG = ReproduceConfig(runs=3, trials=700, ablation_runs=2)
FIGURES = ("figure_5a", "figure_5b", "figure_6a", "figure_6b")


@pytest.fixture(scope="module")
def shown():
    """A recording that says it is of the physics that is installed."""
    made = recording(left=(ideal, ideal), right=(ideal, ideal))
    return replace(made, key=RecordingKey.present(made.key.config))


@pytest.fixture(scope="module", autouse=True)
def few_variants():
    """Two choices are enough to see the table; sources are read elsewhere."""
    with pytest.MonkeyPatch.context() as patch:
        both = [v for v in choices.variants() if v.factor == "bootstrapping at the cap"]
        patch.setattr(choices, "variants", lambda: both)
        patch.setattr(digests, "source_digest", lambda: "sources")
        patch.setattr(RecordingKey, "differences", lambda *keys: ["physics changed"])
        yield


@pytest.fixture(scope="module")
def live(tmp_path_factory):
    """Folders of two live runs, and of one that isn't finished."""
    folder = tmp_path_factory.mktemp("live")
    live_runs(folder, np.random.default_rng(0).integers(2, 11, (2, 700)))
    live_run(folder / "seed-0002", [10] * 40, trials=700, seed=2)
    return folder


@pytest.fixture(scope="module")
def done(tmp_path_factory, shown, live):
    out = tmp_path_factory.mktemp("reproduction")
    ticks = []
    reproduce(shown, CONFIG, out, 1, live, lambda: ticks.append(1))
    assert len(ticks) == n_steps() == 6
    return out


@pytest.fixture
def untimed(done, monkeypatch):
    """Without the measurement of speed, once `done` has it."""
    monkeypatch.setattr(driver, "measured_speed", lambda *given: Speed(2.0, 1.0))


@pytest.fixture
def undrawn(untimed, monkeypatch):
    """Nor the paper's figures, which take the longest, and are seen elsewhere."""
    monkeypatch.setattr(pictures, "published", lambda *given: ())


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
    assert rows.num_rows == sum(len(said.measures) for said in STATEMENTS)
    assert pq.ParquetFile(done / "ablation.parquet").metadata.num_rows == 2
    assert not [file for file in done.rglob("*") if file.name.startswith(".")]


def test_the_report_tells_every_statement_with_its_verdict(done, shown):
    report = (done / "report.md").read_text("utf-8")
    for statement in STATEMENTS:
        (line,) = {
            line
            for line in report.splitlines()
            if line.startswith(f"| {statement.text} | {statement.target.words} | ")
            and f" | {statement.measures[0].title}: " in line
        }
        fitted = ", fitted" if statement.fitted else ""
        if statement.follows:
            fitted = ", follows from two fitted ones"
        verdict = rf"\*\*({'|'.join(Verdict)})\*\*{fitted} \|$"
        assert re.search(verdict, line)
    assert "2 presentations with the lid to the left and 2" in report
    assert "best possible mean is 2.000" in report
    assert "of those who explore as the learner does, 2.09" in report
    assert "700 trials per run" in report
    assert f"key {shown.key.digest[:16]}, seed 0, harmonic gross motion" in report
    assert "Changes: physics changed." in report
    lacking = "2 (1 unfinished, 17 of the 20 expected not begun)"
    assert f"Complete runs on live physics: {lacking}. " in report


def test_a_killed_reproduction_goes_on_where_it_was(
    tmp_path, shown, done, live, monkeypatch, untimed
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


def test_a_finished_one_learns_nothing_anew_and_may_get_live_runs_or_lose_them(
    tmp_path, shown, done, live, monkeypatch, undrawn
):
    copy = tmp_path / "copy"
    shutil.copytree(done, copy)
    monkeypatch.setattr(store, "run_population", None)
    live_run(tmp_path / "unfinished" / "one", [10] * 40)
    reproduce(shown, CONFIG, copy, 1, tmp_path / "unfinished")
    assert "of 1 live runs none is complete" in (copy / "report.md").read_text()
    assert not list(copy.glob("live.*"))
    reproduce(shown, CONFIG, copy, 1, live)
    assert without_times(copy / "report.md") == without_times(done / "report.md")
    for name in ("live.png", "live.parquet"):
        assert (copy / name).read_bytes() == (done / name).read_bytes()
    reproduce(shown, CONFIG, copy, 1)
    assert "no live runs were given" in (copy / "report.md").read_text()
    assert not list(copy.glob("live.*"))


def test_other_folders_are_refused_and_left_as_they_are(tmp_path, shown, done):
    (tmp_path / "thesis.tex").touch()
    with pytest.raises(RunFolderError, match="not empty"):
        reproduce(shown, CONFIG, tmp_path, 1)
    with pytest.raises(RunFolderError, match="not a folder"):
        reproduce(shown, CONFIG, tmp_path / "thesis.tex", 1)
    assert [file.name for file in tmp_path.iterdir()] == ["thesis.tex"]
    with pytest.raises(RunFolderError, match=r"\(runs: 3, not 4\)"):
        reproduce(shown, replace(CONFIG, runs=4), done, 1)
    other = recording(left=(ideal,), right=(ideal,))
    with pytest.raises(RunFolderError, match=r"\(it learned from another recording\)"):
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
    with pytest.raises(RunFolderError, match="populations is not a folder"):
        reproduce(shown, CONFIG, tmp_path / "copy", 1)


def test_jobs_are_told_as_they_were_when_it_was_learned_and_older_files_counted(
    tmp_path, shown, done, undrawn
):
    shutil.copytree(done, tmp_path / "copy")
    old = tmp_path / "copy" / "populations" / "baseline-0123456789abcdef.parquet"
    old.touch()
    with pytest.warns(UserWarning, match="no longer read: 1$"):
        reproduce(shown, CONFIG, tmp_path / "copy", 7)
    assert old.exists()
    report = (tmp_path / "copy" / "report.md").read_text()
    assert "(threads: 1)" in report


def test_equal_choices_have_equal_intervals(
    done, shown, monkeypatch, tmp_path, undrawn
):
    default = choices.variants()[0]
    twice = [replace(default, factor=name) for name in ("one", "other")]
    monkeypatch.setattr(choices, "variants", lambda: twice)
    shutil.copytree(done, tmp_path / "copy")
    with pytest.warns(UserWarning, match="no longer read"):
        reproduce(shown, CONFIG, tmp_path / "copy", 1)
    rows = pq.ParquetFile(tmp_path / "copy" / "ablation.parquet").read().to_pylist()
    first, second = ({**row, "factor": ""} for row in rows)
    # NaN, for what was never there, is equal to itself here.
    np.testing.assert_equal(first, second)


@pytest.mark.parametrize(
    "sizes",
    [
        {"runs": 0},
        {"runs": 1},
        {"runs": -5},
        {"runs": 10**9},
        {"trials": 0},
        {"trials": -1},
        {"trials": 699},
        {"trials": 10**9},
        {"ablation_runs": 0},
        {"runs": 10_000, "trials": 2000},
        {"runs": 10_001, "trials": 700},
        {"trials": 10_001},
        {"seed": -1},
    ],
    ids=str,
)
def test_sizes_that_make_no_experiment_are_refused(sizes):
    with pytest.raises(InvalidValue):
        ReproduceConfig(**sizes)


def test_the_least_and_the_most_make_one():
    for sizes in ({"runs": 2, "trials": 700}, {"runs": 10_000}, {"trials": 10_000}):
        ReproduceConfig(**sizes)
    assert ReproduceConfig(runs=7).ablation.runs == 7


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
        ("--trials 12", "expected an integer from 700"),
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


@pytest.fixture
def given(shown, monkeypatch, tmp_path):
    """The command on the ideal recording, in a folder of its own."""
    monkeypatch.setattr(Recording, "load", lambda path: shown)
    monkeypatch.setattr(Recording, "warn_if_foreign", lambda recording: None)
    monkeypatch.chdir(tmp_path)
    sizes = "--runs 2 --trials 700 --ablation-runs 2 --jobs 1"
    return [*sizes.split(), "--out", "out"]


def test_the_command_writes_the_report_and_nothing_but_its_path(
    tmp_path, given, capsys, undrawn
):
    assert command.main(given) == 0
    said = capsys.readouterr()
    assert said.out == "wrote out/report.md\n"
    assert said.err == ""
    # Another process at work there is an error, too.
    with LockedFolder(tmp_path / "out"):
        assert command.main(given) == 2
    assert "in use by another process" in capsys.readouterr().err
    more = [word if word != "2" else "3" for word in given]
    assert command.main(more) == 2
    words = "out holds another reproduction (runs: 2, not 3, ablation runs: 2, not 3)"
    assert words in capsys.readouterr().err


def test_the_command_compares_live_runs(tmp_path, given, capsys, undrawn):
    # As many actions as the cap allows in every trial: those runs never learned.
    live_runs(tmp_path / "live", np.full((20, 700), 10))
    assert command.main([*given, "--live", "live"]) == 0
    assert capsys.readouterr().err == ""
    report = (tmp_path / "out" / "report.md").read_text()
    assert "Complete runs on live physics: 20. " in report
    assert "**They do not agree.**" in report
    table = pq.ParquetFile(tmp_path / "out" / "live.parquet").read()
    assert table["live"].to_pylist() == [10.0] * 70
    assert (tmp_path / "out" / "live.png").is_file()


def test_live_runs_that_did_what_recorded_ones_did_agree(
    tmp_path, given, shown, undrawn
):
    settings = PopulationSettings(runs=20, seed=4)
    learned = run_population(shown, Scenario(700), settings)
    live_runs(tmp_path / "live", learned.n_actions)
    # Of so many that their own chance adds little to that of the twenty.
    given[1] = "200"
    assert command.main([*given, "--live", "live"]) == 0
    report = (tmp_path / "out" / "report.md").read_text()
    assert "**They agree.**" in report


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("nowhere", "nowhere, where live runs should be, is not there"),
        ("file", "file, where live runs should be, is not a folder"),
        ("empty", "empty has no run folder in it"),
        ("other", "its pretrain is 400, not 0"),
        ("twice", "has the seed of a, 0"),
        ("half", "config.yaml"),
    ],
)
def test_bad_live_runs_are_one_line_and_nothing_is_written(
    tmp_path, given, capsys, name, message
):
    few = [10] * 20
    (tmp_path / "file").touch()
    (tmp_path / "empty").mkdir()
    live_run(tmp_path / "other" / "a", few, trials=700, pretrain=400)
    for copy in ("twice/a", "twice/b", "half/a"):
        live_run(tmp_path / copy, few, trials=700)
    (tmp_path / "half" / "a" / "config.yaml").write_text("prospect_mj_run: [1")
    assert command.main([*given, "--live", name]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("error: ")
    assert message in line
    assert not (tmp_path / "out").exists()
