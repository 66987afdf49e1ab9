import io
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import ideal_env
import pytest

from prospect_mj.cli import command_line
from prospect_mj.errors import (
    InvalidValue,
    MissingFile,
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
        (PermissionError(13, "Permission denied"), 1),
    ],
    ids=lambda value: type(value).__name__,
)
def test_failures_are_one_line_and_an_exit_code(error, code, capsys):
    assert command_line.run(raising(error)) == code
    said = capsys.readouterr().err
    assert said == f"error: {' '.join(str(error).split())}\n"


def test_interruption_promises_only_what_the_command_keeps(capsys):
    interrupted = raising(KeyboardInterrupt())
    assert command_line.run(interrupted) == 130
    assert capsys.readouterr().err == "interrupted\n"
    assert command_line.run(interrupted, "interrupted: all is kept") == 130
    assert capsys.readouterr().err == "interrupted: all is kept\n"


def test_programming_errors_are_not_hidden():
    with pytest.raises(ZeroDivisionError):
        command_line.run(lambda: print(1 / 0))


@dataclass(frozen=True)
class Options:
    seed: int = 0

    def __post_init__(self):
        if self.seed < 0:
            raise InvalidValue("seed", self.seed, "0 or more")


@pytest.mark.parametrize(
    ("argv", "message"),
    [
        (["--seed", "-1"], "seed is -1; expected 0 or more"),
        (["--seed", "x"], "--seed"),
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
    for word in ("Options", "help", "----", "Value error", "─"):
        assert word not in str(refused.value)


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
