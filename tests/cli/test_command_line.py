import io
import os
import signal
import subprocess
import sys
import warnings
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import ideal_env
import pytest
from tqdm import tqdm

from prospect_mj.cli import command_line
from prospect_mj.errors import (
    InvalidValue,
    MissingFile,
    RenderingUnavailable,
    RunFolderError,
    SimulationDiverged,
)

ROOT = Path(__file__).resolve().parents[2]


def raising(error):
    def command():
        raise error

    return command


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (InvalidValue("seed", -1, "0 or more"), 2),
        (RunFolderError("no run folder"), 2),
        (MissingFile("torso.xml is missing"), 2),
        (SimulationDiverged("bad acceleration\nin joint 3"), 1),
        (OSError(28, "No space left on device"), 1),
        (PermissionError(13, "Permission denied"), 2),
    ],
    ids=lambda value: type(value).__name__,
)
def test_failures_are_one_line_and_an_exit_code(error, code, capsys):
    assert command_line.run(raising(error)) == code
    said = capsys.readouterr().err
    assert said == f"error: {' '.join(str(error).split())}\n"


def test_a_file_that_may_not_be_read_is_named_without_a_number(capsys):
    error = PermissionError(13, "Permission denied", "run/config.yaml")
    assert command_line.run(raising(error)) == 2
    assert capsys.readouterr().err == "error: run/config.yaml: Permission denied\n"


def test_interruption_promises_only_what_the_command_keeps(capsys):
    interrupted = raising(KeyboardInterrupt())
    assert command_line.run(interrupted) == 130
    assert capsys.readouterr().err == "interrupted\n"
    assert command_line.run(interrupted, "interrupted: all is kept") == 130
    assert capsys.readouterr().err == "interrupted: all is kept\n"


def test_an_interruption_that_a_library_made_another_error_of_is_one(capsys):
    """As of Ctrl-C in a function that C calls back, while OpenGL is looked for."""

    def command():
        try:
            signal.raise_signal(signal.SIGINT)
        except KeyboardInterrupt as error:
            raise RenderingUnavailable("argument 1: KeyboardInterrupt") from error

    usual = signal.getsignal(signal.SIGINT)
    assert command_line.run(command) == 130
    assert capsys.readouterr().err == "interrupted\n"
    assert signal.getsignal(signal.SIGINT) is usual
    assert command_line.run(raising(RenderingUnavailable("no driver"))) == 2


def test_a_command_whose_interruption_is_ignored_goes_on(monkeypatch):
    usual = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        assert command_line.run(lambda: signal.raise_signal(signal.SIGINT)) == 0
    finally:
        signal.signal(signal.SIGINT, usual)


CLOSED = """
import os, subprocess, sys, tqdm
from prospect_mj.cli import command_line

def command():
    print("told")
    for _ in tqdm.tqdm(range(3), disable=None):
        print("aside", file=sys.stderr, flush=True)
    subprocess.run([sys.executable, "-c", "import sys; sys.stderr.fileno()"],
                   check=True, stdin=subprocess.DEVNULL)
    with open("done", "w"):
        pass

sys.exit(command_line.run(command))
"""


@pytest.mark.parametrize("closed", [">&-", "2>&-", "<&- >&- 2>&-"])
def test_a_command_does_its_work_with_closed_streams(closed, tmp_path):
    shell = ["sh", "-c", f'exec "$0" -c "$1" {closed}', sys.executable, CLOSED]
    done = subprocess.run(shell, cwd=tmp_path, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "done").exists()
    # What is for the one stream never goes to the other.
    assert b"aside" not in done.stdout
    assert b"told" not in done.stderr


def test_programming_errors_are_not_hidden():
    with pytest.raises(ZeroDivisionError):
        command_line.run(lambda: print(1 / 0))


@dataclass(frozen=True)
class Learner:
    step_size: float = 1.0

    def __post_init__(self):
        if self.step_size < 1:
            raise InvalidValue("step size", self.step_size, "1 or more")


@dataclass(frozen=True)
class Options:
    learner: Learner = field(default_factory=Learner)
    seed: int = 0
    speed: float = 1.0
    trial: int | None = None
    lid: Literal["left", "right"] = "left"

    def __post_init__(self):
        if self.seed < 0:
            raise InvalidValue("seed", self.seed, "0 or more")


@pytest.mark.parametrize(
    ("argv", "message"),
    [
        (["--seed", "-1"], "seed is -1; expected 0 or more"),
        (["--seed", "x"], "--seed is 'x'; expected a whole number"),
        (["--seed", "1e3"], "--seed is '1e3'; expected a whole number"),
        (["--seed="], "--seed is ''; expected a whole number"),
        (["--trial", "one"], "--trial is 'one'; expected a whole number"),
        (["--speed", "fast"], "--speed is 'fast'; expected a number"),
        (["--lid", "up"], "--lid is 'up'; valid: left, right"),
        (["--seed"], "--seed is given without a value"),
        (["--sead", "1"], "--sead"),
    ],
)
@pytest.mark.parametrize("encoding", ["utf-8", "ascii"])
def test_options_are_refused_without_the_parsers_own_words(
    argv, message, encoding, monkeypatch
):
    stdout = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
    monkeypatch.setattr("sys.stdout", stdout)
    with pytest.raises(command_line.BadOptions) as refused:
        command_line.parse(Options, argv, Options(), "prog")
    assert message in str(refused.value)
    for word in ("Options", "help", "----", "Value error", "─", "int()"):
        assert word not in str(refused.value)


def do(options):
    """A command with a rule for its seed, which it does not know to be an option."""
    if options.seed > 9:
        raise InvalidValue("seed", options.seed, "9 or less")
    raise RunFolderError("seed is not a run folder")


@pytest.mark.parametrize(
    ("argv", "message"),
    [
        (["--seed", "-1"], "--seed is -1; expected 0 or more"),
        (["--seed=-1"], "--seed is -1; expected 0 or more"),
        (["--speed", "2", "--seed", "10"], "--seed is 10; expected 9 or less"),
        (["--seed", "1"], "seed is not a run folder"),
        (["--learner.step-size=0"], "--learner.step-size is 0.0; expected 1 or more"),
    ],
)
def test_a_bad_value_has_the_name_of_the_option_that_brought_it(argv, message, capsys):
    """Wherever it is found out; a folder of that name is none."""
    assert command_line.main(do, Options(), "prog", argv) == 2
    assert capsys.readouterr().err == f"error: {message}\n"


def test_a_bad_value_that_no_option_brought_keeps_its_name(capsys):
    assert command_line.main(do, Options(seed=10), "prog", []) == 2
    assert capsys.readouterr().err == "error: seed is 10; expected 9 or less\n"


def test_a_warning_is_a_line_of_its_own_beside_a_bar(monkeypatch):
    stderr = io.StringIO()
    monkeypatch.setattr("sys.stderr", stderr)

    def warn():
        with tqdm(total=2, file=stderr, disable=False, ncols=40) as bar:
            bar.update()
            warnings.warn("the lamp is dim", stacklevel=1)

    assert command_line.run(warn) == 0
    assert "\rwarning: the lamp is dim\n" in stderr.getvalue()


COMMANDS = {
    "help": [str(ROOT / "scripts" / "train.py"), "--help"],
    "training": [ideal_env.__file__, "0", "--trials", "2", "--out", "run"],
}


@pytest.mark.parametrize("command", COMMANDS.values(), ids=COMMANDS.keys())
def test_a_reader_that_stops_reading_gets_no_complaint(command, tmp_path):
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run(
        [sys.executable, *command],
        cwd=tmp_path,
        stdout=write,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
    )
    os.close(write)
    assert done.stderr == ""
    assert done.returncode == 1
