"""Making runs on live physics: started, resumed, and none held up by another."""

import json
import shutil
import warnings

import pytest
from ideal_env import IdealEnv

from prospect_mj.cli import live_runs as command
from prospect_mj.errors import (
    InvalidValue,
    RunFolderError,
    SimulationDiverged,
    UnforeseenEvent,
)
from prospect_mj.experiment.paper.live import live_runs
from prospect_mj.experiment.paper.live.live_runs import LiveRuns
from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.run_folder import RunFolder
from prospect_mj.experiment.run.side_by_side import Ended, Warned, check_all_finished
from prospect_mj.sim import gl


def quiet(words):
    pass


def run(path, trials, seed, env=IdealEnv):
    session.start(TrainConfig(trials=trials, seed=seed), path, env, quiet)


def stop_after(n_trials):
    """An environment that is interrupted in the trial after so many."""

    class Stopping(IdealEnv):
        def reset(self, *, seed, options):
            if options["trial"] >= n_trials:
                raise KeyboardInterrupt
            return super().reset(seed=seed, options=options)

    return Stopping


def actions(path):
    with RunFolder.open(path) as folder:
        return folder.trials["n_actions"].to_pylist()


@pytest.fixture(scope="module")
def begun(tmp_path_factory):
    """A complete run of twenty trials, and one that was stopped after twelve."""
    folder = tmp_path_factory.mktemp("begun")
    run(folder / "seed-0000", 20, 0)
    with pytest.raises(KeyboardInterrupt):
        run(folder / "seed-0002", 20, 2, stop_after(12))
    return folder


@pytest.fixture
def folder(tmp_path, begun):
    shutil.copytree(begun, tmp_path / "live")
    return tmp_path / "live"


def advance(folder, runs=3, trials=20, env=IdealEnv):
    return list(live_runs.advance(LiveRuns(runs, trials), folder, 1, env))


def test_runs_are_started_and_resumed_and_left_when_they_are_finished(folder, tmp_path):
    finished = folder / "seed-0000" / "trials.parquet"
    before = finished.stat().st_mtime_ns
    ended = advance(folder)
    assert [one.path.name for one in ended] == ["seed-0000", "seed-0001", "seed-0002"]
    assert not any(one.failure for one in ended)
    check_all_finished(ended)
    assert finished.stat().st_mtime_ns == before
    run(tmp_path / "never-stopped", 20, 2)
    assert actions(folder / "seed-0002") == actions(tmp_path / "never-stopped")


def test_a_run_that_was_made_longer_stays_so(folder):
    check_all_finished(advance(folder, trials=5))
    lengths = [len(actions(folder / f"seed-{seed:04d}")) for seed in range(3)]
    assert lengths == [20, 5, 20]


def test_nothing_is_said_of_each(tmp_path, capsys):
    advance(tmp_path, 1, 3)
    said = capsys.readouterr()
    assert said.out == said.err == ""


def test_one_that_can_not_be_used_keeps_no_other_from_its_end(folder):
    path = folder / "seed-0000" / "config.yaml"
    half = path.read_text()[:300]
    path.write_text(half)
    ended = advance(folder)
    failures = [one.path.name for one in ended if one.failure]
    assert failures == ["seed-0000"]
    others = ("seed-0001", "seed-0002")
    assert [len(actions(folder / name)) for name in others] == [20, 20]
    assert path.read_text() == half
    words = r"1 of 3 runs failed, the others are finished: seed-0000: .*config\.yaml"
    with pytest.raises(RunFolderError, match=words):
        check_all_finished(ended)


def test_physics_that_fails_in_one_run_fails_in_that_alone(tmp_path):
    class Diverging(IdealEnv):
        def __init__(self, config):
            super().__init__(config)
            self.seed = config.seed

        def step(self, action):
            if self.seed == 1:
                raise SimulationDiverged("bad acceleration")
            return super().step(action)

    ended = advance(tmp_path, 3, 4, Diverging)
    assert [one.failure is None for one in ended] == [True, False, True]
    with pytest.raises(ChildProcessError, match="seed-0001: bad acceleration"):
        check_all_finished(ended)


def test_what_is_not_caught_is_not_hidden(tmp_path):
    class Wrong(IdealEnv):
        def step(self, action):
            raise AssertionError("a mistake in the program")

    with pytest.raises(AssertionError):
        advance(tmp_path, 1, 4, Wrong)


def test_warnings_are_handed_on(tmp_path):
    class Dim(IdealEnv):
        def __init__(self, config):
            super().__init__(config)
            warnings.warn(f"lamp {config.seed} is dim", stacklevel=1)

    ended = advance(tmp_path, 2, 3, Dim)
    assert [one.warned for one in ended] == [
        (Warned(f"lamp {seed} is dim", UserWarning),) for seed in (0, 1)
    ]


@pytest.mark.parametrize(
    ("failures", "kind"),
    [
        ([SimulationDiverged("x"), UnforeseenEvent("y", "z")], ChildProcessError),
        ([OSError("disk full")], ChildProcessError),
        ([SimulationDiverged("x"), RunFolderError("y")], RunFolderError),
    ],
)
def test_failures_are_of_the_input_if_one_is(tmp_path, failures, kind):
    ended = [Ended(tmp_path / str(k), one, ()) for k, one in enumerate(failures)]
    with pytest.raises(kind, match=f"^{len(ended)} of {len(ended) + 1} runs failed"):
        check_all_finished([*ended, Ended(tmp_path / "fine", None, ())])


@pytest.mark.parametrize("sizes", [(0, 10), (-1, 10), (5, 0), (10**9, 10)])
def test_no_runs_or_absurdly_many_are_refused(sizes):
    with pytest.raises(InvalidValue):
        LiveRuns(*sizes)


@pytest.fixture
def ideal(monkeypatch):
    """The command on an ideal environment, without a renderer."""

    def advance(wanted, out, jobs):
        return live_runs_advance(wanted, out, jobs, IdealEnv)

    live_runs_advance = live_runs.advance
    monkeypatch.setattr(gl, "require_gl", lambda: None)
    monkeypatch.setattr(live_runs, "advance", advance)


def options(folder):
    return ["--runs", "3", "--trials", "20", "--jobs", "1", "--out", str(folder)]


def test_the_command_makes_the_runs_and_says_where(ideal, folder, capsys):
    assert command.main(options(folder)) == 0
    said = capsys.readouterr()
    assert said.out == f"{folder}: 3 runs are finished\n"
    lines = [f"seed-000{seed} finished, {seed + 1} of 3" for seed in range(3)]
    assert said.err.splitlines() == lines


def test_one_run_is_told_of_as_one(ideal, tmp_path, capsys):
    live = tmp_path / "live"
    words = f"--runs 1 --trials 2 --jobs 1 --out {live}"
    assert command.main(words.split()) == 0
    assert capsys.readouterr().out == f"{live}: 1 run is finished\n"


def test_on_a_terminal_trials_are_counted(ideal, folder, capsys, monkeypatch):
    """Runs take minutes each; of one that was made longer no more than are wanted."""
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    words = ["--runs", "3", "--trials", "15", "--jobs", "1", "--out", str(folder)]
    assert command.main(words) == 0
    bar = capsys.readouterr().err
    # The longer one, and the twelve trials of the one that was stopped.
    assert " 27/45 " in bar
    assert " 45/45 " in bar
    assert "3 of 3 runs" in bar
    assert "seed" not in bar


def test_a_program_gets_one_json_object(ideal, folder, capsys):
    """Of every run what several trained at once say of each."""
    assert command.main([*options(folder), "--json"]) == 0
    said = capsys.readouterr()
    found = json.loads(said.out)
    assert found["path"] == str(folder)
    assert [one["seed"] for one in found["runs"]] == [0, 1, 2]
    for one in found["runs"]:
        n_actions = actions(folder / f"seed-{one['seed']:04d}")
        assert one["path"] == str(folder / f"seed-{one['seed']:04d}")
        assert one["trials"] == len(n_actions) == 20
        assert one["last_mean"] == pytest.approx(sum(n_actions) / 20)


def test_a_program_gets_no_object_where_a_run_failed(ideal, folder, capsys):
    (folder / "seed-0001").touch()
    assert command.main([*options(folder), "--json"]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.splitlines()[-1].startswith("error: 1 of 3 runs failed")


def test_the_command_tells_all_that_failed_in_one_line(ideal, folder, capsys):
    (folder / "seed-0000" / "config.yaml").write_text("half: [")
    (folder / "seed-0001").touch()
    assert command.main(options(folder)) == 2
    said = capsys.readouterr()
    assert said.out == ""
    *ended, line = said.err.splitlines()
    assert [words.split(",")[0] for words in ended] == [
        *("seed-0000 failed", "seed-0001 failed", "seed-0002 finished"),
    ]
    assert line.startswith("error: 2 of 3 runs failed")
    assert "seed-0000: " in line
    assert "seed-0001: " in line
    assert len(actions(folder / "seed-0002")) == 20


def test_the_command_hands_warnings_on(ideal, tmp_path, capsys, monkeypatch):
    def warned(wanted, out, jobs):
        told = (Warned("the lamp is dim", RuntimeWarning),)
        yield Ended(out / "seed-0000", None, told)

    monkeypatch.setattr(live_runs, "advance", warned)
    assert command.main(options(tmp_path)) == 0
    line = capsys.readouterr().err.splitlines()[-1]
    assert line == "warning: seed-0000: the lamp is dim"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("--runs 0", "--runs is 0"),
        ("--runs -1", "--runs is -1"),
        ("--trials 0", "--trials is 0"),
        ("--jobs 0", "--jobs is 0"),
        ("--backend ray", "--backend"),
        ("--out notes.txt", "notes.txt is not a folder"),
        ("--out notes.txt/live", "notes.txt/live can't be made"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(
    ideal, tmp_path, monkeypatch, capsys, words, message
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "notes.txt").touch()
    assert command.main(words.split()) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("error: ")
    assert message in line
    assert [file.name for file in tmp_path.iterdir()] == ["notes.txt"]
