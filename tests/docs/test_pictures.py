"""Which command draws which picture of the pages, as CONTRIBUTING.md says."""

import re

import pytest
from pages import DOCS, ROOT

_TABLE_OF_THE_STUDY = "The study puts its pictures"


@pytest.fixture(scope="module")
def section():
    text = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    return text.partition("## Pictures of the pages")[2].partition("\n## ")[0]


def named(text, column):
    """Pictures that a column of tables names."""
    lines = [line.split("|") for line in text.splitlines() if line.startswith("|")]
    return {
        name for cells in lines for name in re.findall(r"`(\S+\.png)`", cells[column])
    }


def test_every_picture_of_the_pages_is_told_and_no_other(section):
    scripts, _, study = section.partition(_TABLE_OF_THE_STUDY)
    there = {one.name for one in (DOCS / "images").glob("*.png")}
    assert named(scripts, 1) | named(study, 2) == there


def test_every_script_that_is_told_is_there(section):
    told = re.findall(r"`(scripts/\S+\.py)`", section)
    assert len(told) >= 7
    assert [one for one in told if not (ROOT / one).is_file()] == []
