"""The command that records, on ideal outcomes: what it tells, and what it refuses."""

import io
import json
import subprocess
import sys
from pathlib import Path

import pytest
from ideal_grower import IdealGrower, content, grow_ideally, grow_with, grown_tree

from prospect_mj.cli import record
from prospect_mj.errors import RenderingUnavailable, UnforeseenEvent
from prospect_mj.recording import growth, provenance
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.packing import Packing
from prospect_mj.recording.recording import Recording
from prospect_mj.sim import gl

ROOT = Path(__file__).resolve().parents[2]
SMALL = ("--presentations", "2", "--depth", "3", "--jobs", "1")
N_OF_TREE = grown_tree(3).n_actions
N_ACTIONS = 4 * N_OF_TREE


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(gl, "require_gl", lambda: None)
    monkeypatch.setattr(gl, "renderer_name", lambda: "pencil")
    return tmp_path


@pytest.fixture(autouse=True)
def ideal(monkeypatch):
    return grow_ideally(monkeypatch)


def run(*options):
    return record.main([*SMALL, *options])


def test_it_records_and_says_how_much(capsys):
    assert run("--out", "it") == 0
    said = capsys.readouterr()
    assert said.out == f"it: {N_ACTIONS} actions recorded\n"
    assert said.err.splitlines()[-1] == f"4 of 4 trees: {N_ACTIONS} actions"
    assert len(said.err.splitlines()) == 4
    assert len(Recording.load(Path("it")).complete(3)) == 4


def test_for_programs_it_is_one_object(capsys):
    assert run("--out", "it", "--pack", "packed", "--json") == 0
    said = capsys.readouterr()
    assert json.loads(said.out) == {
        "path": "it",
        "n_actions": N_ACTIONS,
        "n_trees": 4,
        "n_failed": 0,
        "pack": {"path": "packed", "n_trees": 4, "n_left_out": 0},
    }
    assert f"it: {N_ACTIONS} actions recorded" in said.err


def test_the_same_command_again_has_nothing_to_do(elsewhere, ideal, capsys):
    assert run("--out", "it") == 0
    before = content(elsewhere)
    ideal.n_run = 0
    capsys.readouterr()
    assert run("--out", "it") == 0
    assert capsys.readouterr() == ("it: 0 actions recorded\n", "")
    assert ideal.n_run == 0
    assert content(elsewhere) == before


def test_on_a_terminal_a_bar_tells_the_remaining_time(monkeypatch):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    screen = Terminal()
    monkeypatch.setattr(growth, "_ACTIONS_PER_UNIT", 5)
    monkeypatch.setattr("sys.stderr", screen)
    monkeypatch.setattr("tqdm.std.tqdm.monitor_interval", 0)
    assert run("--out", "it") == 0
    last = screen.getvalue().split("\r")[-1]
    assert "100%" in last
    assert f"{N_ACTIONS}/{N_ACTIONS}" in last
    assert "4 of 4 trees" in last
    assert "<00:00" in last
    assert "error" not in screen.getvalue()


def test_packing_says_how_many_trees_and_how_many_are_left_out(capsys):
    assert run("--out", "it") == 0
    capsys.readouterr()
    fewer = ("--presentations", "1", "--depth", "2", "--jobs", "1")
    assert record.main([*fewer, "--out", "it", "--pack", "packed"]) == 0
    said = capsys.readouterr().out.splitlines()
    assert said[1] == "packed: 2 trees packed"
    assert said[2].startswith("2 trees of it left out: ")
    assert len(said) == 3
    assert len(Recording.load(Path("packed")).presentations.root) == 2


def test_packing_everything_leaves_nothing_out(capsys):
    assert run("--out", "it", "--pack", "packed") == 0
    assert capsys.readouterr().out.splitlines()[1:] == ["packed: 4 trees packed"]


def test_interrupted_it_keeps_what_it_has(monkeypatch, capsys, ideal):
    class Interrupted(ideal):
        def extend(self, tree, edge):
            if ideal.n_run == 20:
                raise KeyboardInterrupt
            super().extend(tree, edge)

    grow_with(monkeypatch, Interrupted)
    assert run("--out", "it") == 130
    assert capsys.readouterr().err.endswith("interrupted: what was recorded is kept\n")
    grow_with(monkeypatch, ideal)
    assert run("--out", "it") == 0
    # One tree was kept; of the second, the work under way was lost.
    assert f"it: {N_ACTIONS - N_OF_TREE} actions" in capsys.readouterr().out


REFUSED = {
    "--presentations 0": "presentations is 0",
    "--presentations -1": "presentations is -1",
    "--presentations 1000000000": "from 1 to 100000",
    "--presentations many": "many",
    "--depth 0": "depth is 0",
    "--depth 99": "from 1 to 40",
    "--jobs 0": "jobs is 0",
    "--backend slurm": "slurm",
    "--seed -1": "seed is -1",
    "--grid-cells 1000": "bytes",
    "--jobs 4096": "jobs is 4096",
    "--out link": "link is not a folder",
    "--pack link": "link is not a folder",
    "--grid-cells 1": "grid cells per joint is 1",
    "--gross-motion fly": "fly",
    "--world moon": "'moon'; valid: standard, post, lamp-right, lamp-high, noisy, ",
    "--out file": "file is not a folder",
    "--out file/below": "file is not a folder",
    "--out thesis": "thesis is not empty, and no recording",
    "--pack thesis": "thesis is not empty; pack into a new folder",
    "--pack file": "file is not a folder",
    "--out new --pack new": "the recording grows in it",
    "--outt x": "--outt",
}


@pytest.mark.parametrize(("options", "named"), REFUSED.items())
def test_bad_input_is_one_line_and_nothing_is_written(
    options, named, elsewhere, capsys, ideal
):
    (elsewhere / "thesis").mkdir()
    (elsewhere / "thesis" / "chapter.tex").write_text("...")
    (elsewhere / "file").write_text("...")
    (elsewhere / "link").symlink_to("nowhere")
    before = content(elsewhere)
    assert record.main([*SMALL, *options.split()]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1
    assert named in said.err
    assert ideal.n_run == 0
    assert content(elsewhere) == before


def test_without_a_cluster_it_says_so(elsewhere, capsys, monkeypatch, ideal):
    monkeypatch.delenv("RAY_ADDRESS", raising=False)
    assert run("--out", "it", "--backend", "ray") == 2
    expected = "RAY_ADDRESS is None; expected host:port of a running Ray cluster"
    assert capsys.readouterr().err == f"error: {expected}\n"
    assert ideal.n_run == 0
    assert not content(elsewhere)


def test_a_place_to_pack_into_is_taken_before_anything_grows(elsewhere, capsys, ideal):
    with Packing.open(elsewhere / "packed", elsewhere / "other"):
        assert run("--out", "it", "--pack", "packed") == 2
        assert "in use by another process" in capsys.readouterr().err
    assert ideal.n_run == 0
    assert not content(elsewhere)


def test_what_fails_is_told_in_the_end_and_the_rest_is_packed(monkeypatch, capsys):
    class Failing(IdealGrower):
        def extend(self, tree, edge):
            if tree.name == ("left", 1):
                raise UnforeseenEvent("success", "nowhere")
            super().extend(tree, edge)

    grow_with(monkeypatch, Failing)
    assert run("--out", "it", "--pack", "packed") == 1
    said = capsys.readouterr()
    assert "packed: 3 trees packed" in said.out
    assert said.err.splitlines()[-2:] == [
        "warning: left 1, node 0, grasp-left: unforeseen event: success; "
        "it can't happen in: nowhere",
        "error: 1 of the trees could not be grown to an end",
    ]
    assert len(Recording.load(Path("packed")).presentations.root) == 3


CHANGED = {
    "source_digest": ("ef", "sources changed since"),
    "installed_versions": ({"mujoco": "99"}, "mujoco 3.17.0, not 99"),
    "model_digests": ({"models/torso.xml": "ab"}, "models/torso.xml changed since"),
}


@pytest.mark.parametrize("what", CHANGED)
def test_other_physics_do_not_mix(what, elsewhere, capsys, monkeypatch):
    now = {"mujoco": "3.17.0"}
    monkeypatch.setattr(provenance, "installed_versions", lambda: now)
    assert run("--out", "it") == 0
    before = content(elsewhere)
    changed, words = CHANGED[what]
    monkeypatch.setattr(provenance, what, lambda: changed)
    capsys.readouterr()
    assert run("--out", "it", "--depth", "4") == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert words in said
    assert "don't mix" in said
    assert content(elsewhere) == before


def test_another_seed_is_another_recording(elsewhere, capsys):
    assert run("--out", "it") == 0
    before = content(elsewhere)
    capsys.readouterr()
    assert run("--out", "it", "--seed", "1") == 2
    assert "made with seed 0, not 1" in capsys.readouterr().err
    assert content(elsewhere) == before


def test_another_world_is_another_recording(elsewhere, capsys):
    assert run("--out", "it", "--world", "post") == 0
    assert RecordingKey.read(Path("it")).config.world == "post"
    before = content(elsewhere)
    capsys.readouterr()
    assert run("--out", "it") == 2
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert "made with world post, not standard" in told
    assert content(elsewhere) == before


def test_a_damaged_tree_is_one_line_and_stays_as_it_is(elsewhere, capsys, ideal):
    assert run("--out", "it") == 0
    path = elsewhere / "it" / "left-0001.parquet"
    path.write_bytes(path.read_bytes()[:-100])
    before = content(elsewhere)
    capsys.readouterr()
    ideal.n_run = 0
    assert run("--out", "it", "--depth", "4") == 2
    said = "error: it/left-0001.parquet can't be read: it is damaged\n"
    assert capsys.readouterr().err == said
    assert content(elsewhere) == before
    assert ideal.n_run == 0


def test_without_opengl_nothing_is_written(elsewhere, monkeypatch, capsys):
    def fail():
        raise RenderingUnavailable("no OpenGL: install libegl1")

    monkeypatch.setattr(gl, "require_gl", fail)
    assert run("--out", "it") == 2
    assert capsys.readouterr().err == "error: no OpenGL: install libegl1\n"
    assert not content(elsewhere)


def test_script_helps_and_is_short():
    script = ROOT / "scripts" / "record.py"
    assert len(script.read_text().splitlines()) <= 20
    done = subprocess.run(
        [sys.executable, script, "--help"], capture_output=True, text=True, check=True
    )
    for option in ("--out", "--pack", "--presentations", "--depth", "--jobs"):
        assert option in done.stdout
