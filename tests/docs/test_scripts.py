"""The scripts on the pages run, those of a page one after the other."""

import os
import subprocess
import sys
from importlib.util import find_spec

import pytest
from pages import DOCS, blocks

PAGES = ("../README.md", "environment.md", "own_skill.md", "skills.md", "worlds.md")
FILMS = "moviepy"
"""What Gymnasium writes films with; `make agents` installs it."""


@pytest.mark.gl
@pytest.mark.slow
@pytest.mark.parametrize("page", PAGES)
def test_scripts_of_a_page_run(page, tmp_path):
    scripts = [b.text for b in blocks(DOCS / page) if b.language == "python"]
    assert scripts
    script = "\n".join(scripts)
    if "save_video" in script and find_spec(FILMS) is None:
        missed = pytest.fail if os.environ.get("AGENTS") == "true" else pytest.skip
        missed(f"needs {FILMS}, which `make agents` installs")
    done = subprocess.run(
        [sys.executable, "-c", script],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )
    assert done.returncode == 0, done.stderr
