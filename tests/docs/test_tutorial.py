"""The tutorial is run as it is written, in an empty folder."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from pages import DOCS, ROOT, Block, blocks, missing_line

SECONDS = 240
"""For all of it, on a machine that does other things as well [s]."""
RUN = "import sys; from prospect_mj.cli.app import main; sys.exit(main())"


def steps() -> list[tuple[Block, str]]:
    """What is run, each with what the page shows of its output."""
    found = blocks(DOCS / "tutorial.md")
    following = [*found[1:], Block("", "")]
    return [
        (block, after.text if after.language == "text" else "")
        for block, after in zip(found, following, strict=True)
        if block.language in ("sh", "python")
    ]


@pytest.fixture
def environment(tmp_path) -> dict[str, str]:
    """`prospect` and `python` are those of this interpreter, wherever it is."""
    programs = tmp_path / "bin"
    programs.mkdir()
    for name, arguments in (("prospect", f"-c '{RUN}'"), ("python", "")):
        program = programs / name
        program.write_text(f'#!/bin/sh\nexec "{sys.executable}" {arguments} "$@"\n')
        program.chmod(0o755)
    paths = [str(ROOT), *filter(None, [os.environ.get("PYTHONPATH")])]
    return os.environ | {
        "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}",
        "PYTHONPATH": os.pathsep.join(paths),
    }


def run(block: Block, folder: Path, environment: dict[str, str]) -> str:
    program = ["sh", "-e"] if block.language == "sh" else ["python", "-"]
    done = subprocess.run(
        program,
        input=block.text,
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=SECONDS,
        check=False,
    )
    assert done.returncode == 0, f"{block.text}\n{done.stdout}\n{done.stderr}"
    return done.stdout + done.stderr


@pytest.mark.gl
@pytest.mark.slow
@pytest.mark.timeout(2 * SECONDS)
def test_tutorial(tmp_path, environment):
    folder = tmp_path / "tutorial"
    folder.mkdir()
    for block, shown in steps():
        output = run(block, folder, environment)
        missing = missing_line(shown, output)
        assert missing is None, f"{block.text} does not print {missing!r} but {output}"
    written = {path.relative_to(folder).as_posix() for path in folder.rglob("*")}
    assert {"worst.rrd", "runs/thousand/learning_curve.png"} <= written


def test_tutorial_has_every_part():
    words = "\n".join(block.text for block, _ in steps())
    for command in ("doctor", "train", "replay", "plot", "evaluate"):
        assert f"prospect {command}" in words
    assert sum(block.language == "python" for block, _ in steps()) >= 3
    assert sum(bool(shown) for _, shown in steps()) >= 5


@pytest.mark.parametrize(
    ("shown", "output", "missing"),
    [
        ("mean 8.60 in 20\n", "mean 7.1 in 20", None),
        ("a\n...\nb", "a\nx\nb", None),
        ("a 1; ...", "a 2; whatever", None),
        ("a\nb", "b\na", "b"),
        ("solved 5", "solved many", "solved 5"),
        ("", "anything", None),
    ],
)
def test_shown_output_is_held_against_what_is_printed(shown, output, missing):
    assert missing_line(shown, output) == missing
