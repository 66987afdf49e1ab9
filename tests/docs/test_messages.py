"""What the page on troubleshooting quotes is what the code says."""

import ast
from collections.abc import Iterator
from functools import cache

import pytest
from pages import DOCS, ROOT, blocks

ELSEWHERE = {"AttributeError: 'MjModel' object has no attribute 'flex_vertedge'"}
"""Said by other people's code."""


def literals() -> Iterator[str]:
    """Every text in the sources; what is filled in at run time is `...`."""
    for file in (ROOT / "prospect_mj").rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.JoinedStr):
                parts = [getattr(part, "value", None) for part in node.values]
                yield "".join(p if isinstance(p, str) else "..." for p in parts)
            elif isinstance(node, ast.Constant) and isinstance(node.value, str):
                yield node.value


@cache
def said() -> str:
    return "\n".join(" ".join(text.split()) for text in literals())


def quoted() -> list[str]:
    texts = [
        b.text for b in blocks(DOCS / "troubleshooting.md") if b.language == "text"
    ]
    lines = [line for text in texts for line in text.splitlines()]
    return [line for line in lines if line not in ELSEWHERE]


def unsaid(line: str) -> list[str]:
    """The parts of a quotation that no text in the sources has."""
    words = line.removeprefix("error: ").removeprefix("warning: ")
    parts = [part.strip(" :();,") for part in words.split("...")]
    return [part for part in parts if part and part not in said()]


@pytest.mark.parametrize("line", quoted())
def test_quotation(line):
    assert not unsaid(line)


def test_a_wrong_quotation_is_found():
    assert len(quoted()) > 12
    assert unsaid("... is not empty; take another one") == [
        "is not empty; take another one"
    ]
