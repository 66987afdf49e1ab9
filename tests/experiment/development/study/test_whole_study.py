"""The whole study on the shipped recordings, with few runs: everything is there."""

import re
from importlib.util import find_spec

import pyarrow.parquet as pq
import pytest

from prospect_mj.cli import development as command
from prospect_mj.experiment.development.study.settings import PARTS

FEW = "--runs 6 --setting-runs 2 --deep-runs 2 --deep-trials 50 --grasped 0 --planned 2"


def parts():
    """Those that need no library that isn't here."""
    without = () if find_spec("torch") else ("rivals",)
    return [part for part in PARTS if part not in without]


@pytest.mark.gl
@pytest.mark.smoke
def test_the_study_of_the_shipped_recordings_is_whole(tmp_path):
    argv = [*FEW.split(), "--out", str(tmp_path), "--parts", *parts()]
    assert command.main(argv) == 0
    report = (tmp_path / "report.md").read_text("utf-8")
    linked = set(re.findall(r"\]\(([^)]*)\)", report))
    assert all((tmp_path / link).is_file() for link in linked)
    drawn = {f"figures/{file.name}" for file in (tmp_path / "figures").iterdir()}
    assert drawn <= linked
    for table in (tmp_path / "tables").iterdir():
        assert pq.read_metadata(table).num_rows > 0
    for part in parts():
        assert f"| {part} | " in report
