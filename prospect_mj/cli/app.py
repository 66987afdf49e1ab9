"""`prospect`: one command line over all others."""

import difflib
import sys
from collections.abc import Sequence
from importlib import import_module
from typing import NamedTuple

import prospect_mj
from prospect_mj.cli import command_line
from prospect_mj.errors import ProspectError


class Command(NamedTuple):
    """One of its commands."""

    module: str
    """Of `prospect_mj.cli`; its `main` takes the arguments and the name in the help."""
    words: str
    """What it does."""


COMMANDS = {
    "train": Command("train", "learn on live or recorded physics"),
    "evaluate": Command("evaluate", "try a run's policy on fresh presentations"),
    "plot": Command("plot", "draw what a run learned"),
    "replay": Command("replay", "replay trials of a run in Rerun's viewer"),
    "video": Command("video", "film a trial of a run"),
    "view": Command("view", "play actions in MuJoCo's viewer, live"),
    "record": Command("record", "record what every sequence of actions leads to"),
    "reproduce": Command("reproduce", "the paper's experiment on recorded physics"),
    "development": Command("development", "which learners develop as infants do"),
    "live-runs": Command("live_runs", "runs on live physics to hold against it"),
    "skill-study": Command("skill_study", "success and duration of every action"),
    "bench": Command("bench", "speed of the simulation, and where the time goes"),
    "doctor": Command("doctor", "what is wrong with this machine, and how to mend it"),
}
"""By name, in the order of the help."""


class UnknownCommand(ProspectError):
    """No command has this name; the message has the nearest one."""

    def __init__(self, name: str) -> None:
        """Name what was given, and what was probably meant."""
        near = difflib.get_close_matches(name, COMMANDS, n=1)
        meant = f"did you mean {near[0]}? " if near else ""
        super().__init__(
            f"there is no command {name!r}; {meant}prospect --help lists them"
        )


def main(argv: Sequence[str] | None = None) -> int:
    """Run one of the commands.

    Args:
        argv: the command and its arguments; None for those of the process.

    Returns:
        The exit code; see `command_line.run`.
    """
    given = sys.argv[1:] if argv is None else argv
    name = given[0] if given else "--help"
    if name in ("--help", "-h"):
        return command_line.run(lambda: print(_help()))
    if name == "--version":
        return command_line.run(lambda: print(f"prospect {prospect_mj.__version__}"))
    if name not in COMMANDS:
        return command_line.run(lambda: _refuse(name))
    try:
        # Only here: some take a second to load, and none needs another.
        command = import_module(f"prospect_mj.cli.{COMMANDS[name].module}")
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return command_line.INTERRUPTED
    return command.main(given[1:], prog=f"prospect {name}")


def _refuse(name: str) -> None:
    raise UnknownCommand(name)


def _help() -> str:
    width = max(map(len, COMMANDS))
    listed = [f"  {name:{width}}  {one.words}" for name, one in COMMANDS.items()]
    return "\n".join(
        [
            "usage: prospect COMMAND [OPTIONS]",
            "",
            "A two-armed torso in MuJoCo learns which hand to pick a jar up with.",
            "",
            *listed,
            "",
            "prospect COMMAND --help lists its options, with units and defaults;",
            "prospect --version tells the version.",
        ]
    )
