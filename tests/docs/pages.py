"""Fenced blocks of the pages, and output held against what a page shows of it."""

import re
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"

_BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_NUMBER = re.compile(r"\d+(\\\.\d+)*")


class Block(NamedTuple):
    language: str
    text: str


def blocks(page: Path) -> list[Block]:
    return [Block(*found) for found in _BLOCK.findall(page.read_text("utf-8"))]


def missing_line(shown: str, output: str) -> str | None:
    """The first line that is shown and is not in the output after those before it.

    Numbers stand for any numbers, `...` for anything, blanks for any blanks.
    """
    printed = iter(output.splitlines())
    for line in filter(str.strip, shown.splitlines()):
        if line.strip() == "...":
            continue
        pattern = as_pattern(line)
        if not any(pattern.fullmatch(" ".join(other.split())) for other in printed):
            return line
    return None


def as_pattern(line: str) -> re.Pattern[str]:
    words = re.escape(" ".join(line.split()))
    anything = words.replace(re.escape("..."), ".*")
    return re.compile(_NUMBER.sub(r"\\d+(\\.\\d+)*", anything))
