"""The page on haptic categories: models made as it says are a feature of the state."""

import subprocess
import sys

from pages import DOCS, blocks

from prospect_mj.haptics import TrajectoryModels


def test_the_script_makes_models_that_the_environment_tells(tmp_path):
    (script,) = (
        block.text
        for block in blocks(DOCS / "haptics.md")
        if "haptic_models=models" in block.text
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
    )
    at_first, held = done.stdout.splitlines()
    assert at_first == "(909,) -1"
    hand, category = held.split()
    assert hand == "left"
    assert 0 <= int(category) < 6
    assert len(TrajectoryModels.read(tmp_path / "haptic_models.json")) == 6
