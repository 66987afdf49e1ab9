"""Where the learners' compiled code is kept, in new processes."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from ideal_recording import ideal, recording
from kept_kernels import kept_functions

from prospect_mj import paths
from prospect_mj.agent import TableSettings
from prospect_mj.experiment.populations import compiled_learner
from prospect_mj.experiment.populations.kernels import cache, linear
from prospect_mj.experiment.populations.population import learn
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.experiment.populations.scenario import (
    LinearSettings,
    PopulationSettings,
    Scenario,
)
from prospect_mj.planning import kernel_cache

PACKAGE = Path(paths.__file__).parent
IMPORT = """
import numba
from prospect_mj.planning import kernel_cache
before = numba.config.CACHE_DIR
from prospect_mj.experiment.populations.kernels import cache, linear
assert numba.config.CACHE_DIR == before, "the planner's code is kept elsewhere"
print(cache.folder())
"""


@pytest.fixture
def read_only(tmp_path):
    """A copy of the package that nothing can be written beside, with no home either.

    Files are in the place of folders, which stops the administrator as well.
    """
    copy = tmp_path / "prospect_mj"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__"))
    for folder in {path.parent for path in copy.rglob("*.py")}:
        (folder / "__pycache__").touch()
    (tmp_path / "home").touch()
    return tmp_path


def test_it_is_in_a_folder_of_its_own_beside_the_planners(tmp_path):
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path)}
    done = subprocess.run(
        [sys.executable, "-c", IMPORT], env=environment, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    folder = Path(done.stdout.strip())
    assert folder.parent == tmp_path
    assert folder.name.endswith(cache.sources()[:16])
    assert not folder.name.endswith(kernel_cache.sources()[:16])


def test_it_works_where_nothing_can_be_written(read_only):
    nowhere = str(read_only / "home" / "of" / "nobody")
    environment = {
        name: value for name, value in os.environ.items() if name != "NUMBA_CACHE_DIR"
    }
    environment |= {
        "PYTHONPATH": str(read_only),
        "HOME": nowhere,
        "XDG_CACHE_HOME": nowhere,
    }
    done = subprocess.run(
        [sys.executable, "-c", IMPORT],
        cwd=read_only,
        env=environment,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    # It was the process's own, and is gone with it.
    assert not Path(done.stdout.strip()).exists()


def learn_in_all_ways():
    """Compile, or read, whatever of two learners is called from Python."""
    once = recording(left=(ideal,), right=(ideal,))
    default, table = LinearSettings(), TableSettings(replays=2)
    for learner, noise in ((default, 0.0), (default, 0.05), (table, 0.0)):
        settings = PopulationSettings(learner=learner, image_noise=noise)
        programme = Programme(once, Scenario(3), settings)
        learned = learn(programme, 0)
        if learner is default:
            trials = programme.run(0).trials
            compiled_learner.run_frozen(learned.learner, programme.graph, trials)


def test_what_is_cached_has_one_signature():
    """Two processes that compile at the same time could mix up two of them.

    The folder is that of the sources as they are: what any process has ever compiled of
    them is there.
    """
    learn_in_all_ways()
    functions = kept_functions(linear.run)
    for learner in ("linear", "table"):
        assert any(f"{learner}.run" in name for name in functions), functions
    assert sorted(set(functions)) == functions


def test_any_change_of_any_source_leads_to_another_folder(tmp_path, monkeypatch):
    sources = sorted(Path(cache.__file__).parent.glob("*.py"))
    for path in sources:
        shutil.copy(path, tmp_path)
    seen = {cache.sources()}
    monkeypatch.setattr(cache, "__file__", str(tmp_path / "cache.py"))
    assert seen == {cache.sources()}
    for path in sources:
        with (tmp_path / path.name).open("a") as file:
            file.write("# changed\n")
        seen.add(cache.sources())
    assert len(seen) == len(sources) + 1 > 8
