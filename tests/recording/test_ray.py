"""The same bytes on a real Ray cluster, whose head the test starts."""

import math
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import pytest
from ideal_grower import content

from prospect_mj.errors import InvalidValue, RecordingError
from prospect_mj.recording.config import Extent, RecordingConfig
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.growth import Growth, Unit, grown
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.workers import Workers

pytestmark = [pytest.mark.gl, pytest.mark.smoke]

ROOT = Path(__file__).resolve().parents[2]


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


@pytest.fixture(scope="module")
def head():
    """Environment of a process that finds the cluster; its head has two CPUs."""
    pytest.importorskip("ray")
    # Its sockets lie there, and their paths must be short.
    folder = Path(tempfile.mkdtemp(prefix="ray-", dir="/tmp"))
    port = free_port()
    quiet = {"RAY_USAGE_STATS_ENABLED": "0"}
    # Set up as a cluster is that nobody has prepared for rendering.
    bare = {n: v for n, v in os.environ.items() if n not in ("MUJOCO_GL", "DISPLAY")}
    with (folder / "head.log").open("w") as log:
        process = subprocess.Popen(
            [
                *(sys.executable, "-m", "ray.scripts.scripts", "start", "--head"),
                *(f"--port={port}", f"--temp-dir={folder}", "--num-cpus=2"),
                *("--include-dashboard=false", "--object-store-memory=100000000"),
                "--block",
            ],
            env=bare | quiet,
            stdout=log,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
    try:
        wait_for(process, folder / "head.log")
        yield bare | quiet | {"RAY_ADDRESS": f"127.0.0.1:{port}"}
        process.terminate()
        process.wait(20)
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
        shutil.rmtree(folder, ignore_errors=True)


def wait_for(process, log):
    until = time.monotonic() + 60
    while "Ray runtime started" not in log.read_text():
        assert process.poll() is None, log.read_text()
        assert time.monotonic() < until, log.read_text()
        time.sleep(0.1)


def record(head, out, *options):
    return subprocess.run(
        [
            *(sys.executable, ROOT / "scripts" / "record.py", "--out", out),
            *("--seed", "4", "--presentations", "1", "--depth", "1"),
            *("--backend", "ray", *options),
        ],
        env=head,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


def test_a_cluster_records_the_same_bytes_as_this_process(head, tmp_path):
    here = tmp_path / "here"
    with GrowingRecording.open(
        here, RecordingKey.present(RecordingConfig(seed=4))
    ) as r:
        list(Growth(r, Extent(1, 1)).run(Workers(jobs=1)))
    there = tmp_path / "there"
    done = record(head, there, "--jobs", "2")
    assert done.returncode == 0, done.stderr
    assert done.stdout == f"{there}: 4 actions recorded\n"
    assert done.stderr.splitlines() == [
        "1 of 2 trees: 2 actions",
        "2 of 2 trees: 4 actions",
    ]
    ours, theirs = content(here), content(there)
    assert set(ours) == set(theirs)
    for name in ("left-0000.parquet", "right-0000.parquet"):
        assert ours[name] == theirs[name]


@pytest.fixture
def connected(head, monkeypatch):
    for name in ("RAY_ADDRESS", "RAY_USAGE_STATS_ENABLED"):
        monkeypatch.setenv(name, head[name])


def test_more_jobs_than_the_cluster_has_room_for_are_refused(connected):
    words = "jobs is 3; expected at most 2, the cluster's CPUs"
    with pytest.raises(InvalidValue, match=words):
        list(Workers(3, "ray").map(math.sqrt, [4]))


def test_processes_stay_for_everything_that_is_mapped(connected):
    with Workers(2, "ray").mapper() as mapped:
        assert list(mapped(math.sqrt, [4, 9])) == [2, 3]
        assert list(mapped(math.sqrt, [16])) == [4]


def test_a_machine_of_other_versions_is_refused_in_its_own_words(connected):
    key = RecordingKey.present(RecordingConfig())
    other = replace(key, versions=key.versions | {"mujoco": "3.16.0"})
    with pytest.raises(RecordingError, match=r"can't grow on .* mujoco 3\.16\.0, not"):
        list(Workers(2, "ray").map(grown, [Unit(other, "left", 0, None, 2)]))


def test_a_cluster_of_other_versions_is_named(connected, monkeypatch):
    monkeypatch.setattr("ray.__version__", "1.0.0")
    with pytest.raises(InvalidValue, match=r"can be joined; .*(?s:.*)Ray: 1\.0\.0"):
        list(Workers(2, "ray").map(math.sqrt, [4]))


def test_a_connection_of_the_caller_stays(connected):
    import ray

    ray.init(os.environ["RAY_ADDRESS"], log_to_driver=False)
    try:
        with pytest.raises(InvalidValue, match="not connected to yet"):
            list(Workers(2, "ray").map(math.sqrt, [4]))
        assert ray.is_initialized()
    finally:
        ray.shutdown()


def test_a_lost_process_of_the_cluster_is_one_clear_error(connected):
    with pytest.raises(ChildProcessError, match="of the Ray cluster was lost"):
        list(Workers(2, "ray").map(os._exit, [1, 1]))
