"""The one command over all others: its help, its names, its options' words."""

import ast
import re
import runpy
import subprocess
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path

import pytest

import prospect_mj
from prospect_mj.cli import app, command_line

ROOT = Path(__file__).resolve().parents[2]
HEAVY = ("cv2", "matplotlib", "mujoco", "numba", "pyarrow", "rerun", "scipy", "tyro")


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "100")


def test_the_help_lists_every_command_and_loads_none(tmp_path):
    code = (
        "import sys; from prospect_mj.cli.app import main; code = main(['--help']);"
        f"print([m for m in {HEAVY} if m in sys.modules], file=sys.stderr);"
        "sys.exit(code)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={"PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stderr == "[]\n"
    for name, command in app.COMMANDS.items():
        assert f"  {name} " in done.stdout
        assert command.words in done.stdout


def test_no_command_is_a_question_for_help(capsys):
    assert app.main([]) == 0
    assert capsys.readouterr().out.startswith("usage: prospect COMMAND")


def test_the_version_is_the_packages(capsys):
    assert app.main(["--version"]) == 0
    assert capsys.readouterr().out == f"prospect {prospect_mj.__version__}\n"


@pytest.mark.parametrize(
    ("given", "meant"),
    [
        ("trian", "train"),
        ("eval", "evaluate"),
        ("live_runs", "live-runs"),
        ("Doctor", "doctor"),
    ],
)
def test_an_unknown_command_is_one_line_with_the_nearest_name(given, meant, capsys):
    assert app.main([given, "--seed", "1"]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err == (
        f"error: there is no command {given!r}; did you mean {meant}? "
        "prospect --help lists them\n"
    )


def test_what_is_near_to_nothing_has_no_nearest_name(capsys):
    assert app.main(["--json"]) == 2
    assert "did you mean" not in capsys.readouterr().err


def test_a_command_gets_its_arguments_and_its_name(capsys):
    assert app.main(["bench", "--trials", "x"]) == 2
    assert "--trials" in capsys.readouterr().err
    with pytest.raises(SystemExit) as end:
        app.main(["bench", "--help"])
    assert end.value.code == 0
    assert "usage: prospect bench" in capsys.readouterr().out


def options_of(text):
    """Words by option, of a help as tyro draws it, in a box or without."""
    found: dict[str, str] = {}
    name = None
    for line in (line.strip("│ \t") for line in text.splitlines()):
        if flag := re.match(r"(?:-h, )?(--[a-z][\w.-]*)(.*)", line):
            name, rest = flag.groups()
            # Words stand in a column of their own, or on the lines below.
            _, _, words = rest.partition("  ")
            found[name] = words.strip()
        elif name is not None:
            found[name] += f" {line}"
    return found


@pytest.mark.parametrize("name", app.COMMANDS)
def test_every_option_has_words_and_a_default(name, capsys):
    with pytest.raises(SystemExit) as end:
        app.main([name, "--help"])
    assert end.value.code == 0
    said = capsys.readouterr().out
    assert said.startswith(f"usage: prospect {name} ")
    options = options_of(said)
    assert "--help" in options
    for option, words in options.items():
        told, *default = words.split("(default:")
        assert len(told.split()) >= 2, (option, words)
        told_at_once = "efault: " in told or option == "--help"
        assert bool(default) != told_at_once, (option, words)
        assert "None" not in words, (option, words)


def test_options_are_read_from_a_help_with_its_gaps():
    drawn = "│ --a INT    Of it [s].   │\n│ --bare {x}  │\n│   (default: 1) │"
    assert options_of(drawn) == {"--a": "Of it [s].", "--bare": " (default: 1)"}


def test_the_page_names_all_commands_that_print_json(capsys):
    have = set()
    for name in app.COMMANDS:
        with pytest.raises(SystemExit):
            app.main([name, "--help"])
        if "--json" in options_of(capsys.readouterr().out):
            have.add(name)
    page = (ROOT / "docs" / "commands.md").read_text("utf-8")
    (told,) = re.findall(r"- `--json` prints[^:]*:([^.]*)\.", page)
    assert set(re.findall(r"`([\w-]+)`", told)) == have


@pytest.mark.parametrize(
    ("name", "option", "unit"),
    [
        ("view", "--speed", "Simulated seconds per second"),
        ("video", "--width", "pixels"),
        ("plot", "--grasps", "second each"),
        ("train", "--max-actions", "actions"),
        ("train", "--learner.discount", "per action"),
        ("record", "--depth", "Executed actions"),
        ("reproduce", "--runs", "Learners per scenario"),
    ],
)
def test_a_number_says_what_of(name, option, unit, capsys):
    with pytest.raises(SystemExit):
        app.main([name, "--help"])
    assert unit in options_of(capsys.readouterr().out)[option]


@dataclass(frozen=True)
class LongWinded:
    """Many words."""

    seed: int = 0
    """The first line of it ends in a word, and the second
    (which begins with none) goes on
    3 lines long."""


def test_the_lines_of_a_docstring_are_joined(capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")
    with pytest.raises(SystemExit):
        command_line.parse(LongWinded, ["--help"], LongWinded(), "prog")
    assert (
        "The first line of it ends in a word, and the second (which begins with none) "
        "goes on 3 lines long." in capsys.readouterr().out
    )


def test_scripts_are_thin_names_of_all_commands():
    modules = {}
    for script in (ROOT / "scripts").glob("*.py"):
        text = script.read_text("utf-8")
        assert len(text.splitlines()) <= 12, script
        found = [n for n in ast.walk(ast.parse(text)) if isinstance(n, ast.ImportFrom)]
        modules[script.stem] = {node.module for node in found}
    for command in app.COMMANDS.values():
        assert modules[command.module] == {f"prospect_mj.cli.{command.module}"}


MAKERS = {"make_jar", "make_torso"}
"""Scripts that write a file each, without any options."""


def test_every_script_of_the_repository_has_a_help(capsys):
    for script in (ROOT / "scripts").glob("*.py"):
        if script.stem not in MAKERS:
            begin = runpy.run_path(str(script))
            (main,) = (f for f in begin.values() if callable(f))
            with pytest.raises(SystemExit) as end:
                main(["--help"])
            assert end.value.code == 0
            assert capsys.readouterr().out.startswith(f"usage: {script.name} ")


def test_it_is_installed_under_its_name():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert project["scripts"] == {"prospect": "prospect_mj.cli.app:main"}
