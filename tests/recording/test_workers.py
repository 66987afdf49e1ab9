"""Work in other processes; the Ray cluster is in test_ray.py."""

import os
import signal
import socket
import subprocess
import sys
import time
from functools import partial
from pathlib import Path

import pytest

from prospect_mj.errors import InvalidValue, MissingPackage
from prospect_mj.recording import ray_cluster
from prospect_mj.recording.workers import Workers


def square(number):
    return number**2, os.getpid()


def met(folder, number):
    """Come back at once; the first only after the result of the other was seen."""
    until = time.monotonic() + 60
    while number == 0 and not folder.exists() and time.monotonic() < until:
        time.sleep(0.01)
    return number


def die(number):
    os.kill(os.getpid(), signal.SIGKILL)


def fail(number):
    # It is made from three arguments, and told by one message.
    raise InvalidValue("number", number, "one that is recorded")


@pytest.mark.parametrize("jobs", [1, 2])
def test_everything_is_done_once(jobs):
    with Workers(jobs).mapper() as mapped:
        done = [*mapped(square, range(5)), *mapped(square, range(5, 9))]
    assert sorted(number for number, _ in done) == [n**2 for n in range(9)]
    here = os.getpid() in {process for _, process in done}
    assert here == (jobs == 1)


def test_results_come_as_they_are_ready(tmp_path):
    """The first piece of work waits for the second, however late that ends."""
    seen = tmp_path / "seen"
    results = Workers(2).map(partial(met, seen), [0, 1])
    first = next(results)
    seen.touch()
    assert [first, *results] == [1, 0]


def test_processes_stay_for_everything_that_is_mapped():
    """Were they new each time, there would be three of them at least."""
    with Workers(2).mapper() as mapped:
        done = [result for _ in range(3) for result in mapped(square, range(4))]
    assert len({process for _, process in done}) <= 2


@pytest.mark.parametrize("jobs", [1, 2])
def test_an_error_of_the_work_comes_through(jobs):
    with pytest.raises(
        InvalidValue, match="number is 3; expected one that is recorded"
    ):
        list(Workers(jobs).map(fail, [3]))


def busy(folder, number):
    (folder / str(os.getpid())).touch()
    time.sleep(60)


def run_by(folder):
    list(Workers(2).map(partial(busy, Path(folder)), range(2)))


def is_alive(process):
    try:
        # Who has ended is there until he is asked for.
        state = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except FileNotFoundError:
        return False
    return state != "Z"


@pytest.mark.skipif(sys.platform != "linux", reason="it looks into /proc")
def test_processes_end_with_the_one_that_was_killed(tmp_path):
    """They would go on for as long as their work takes, and wait for minutes more."""
    script = (
        "import pathlib, sys, test_workers as t; t.run_by(pathlib.Path(sys.argv[1]))"
    )
    command = [sys.executable, "-c", script, str(tmp_path)]
    paths = os.pathsep.join([str(Path(__file__).parent), *filter(None, sys.path)])
    killed = subprocess.Popen(command, env={**os.environ, "PYTHONPATH": paths})
    deadline = time.monotonic() + 15
    while len(list(tmp_path.iterdir())) < 2 and time.monotonic() < deadline:
        time.sleep(0.02)
    working = [int(path.name) for path in tmp_path.iterdir()]
    killed.kill()
    killed.wait()
    while any(map(is_alive, working)) and time.monotonic() < deadline:
        time.sleep(0.05)
    left = [process for process in working if is_alive(process)]
    for process in left:
        os.kill(process, signal.SIGKILL)
    assert len(working) == 2
    assert not left


ORPHAN = """
import sys, time
from prospect_mj.recording import workers
workers.end_with(int(sys.argv[1]))
time.sleep(60)
"""


def test_a_process_whose_command_was_killed_before_its_first_work_ends_too():
    gone = subprocess.Popen([sys.executable, "-c", ""])
    gone.wait()
    orphan = [sys.executable, "-c", ORPHAN, str(gone.pid)]
    assert subprocess.run(orphan, timeout=30, check=False).returncode == 1


def test_a_lost_process_is_one_clear_error_of_the_machine():
    with pytest.raises(ChildProcessError, match="killed, or ran out of memory"):
        list(Workers(2).map(die, range(2)))
    assert len(list(Workers(2).map(square, range(3)))) == 3


ADDRESSES = {
    "unset": None,
    "empty": "",
    "auto": "auto",
    "no port": "127.0.0.1",
    "no number": "127.0.0.1:head",
    "absurd port": "127.0.0.1:99999",
    "no such host": "nowhere.invalid:6379",
    "Ray client": "ray://127.0.0.1:10001",
}


@pytest.mark.parametrize("address", ADDRESSES.values(), ids=ADDRESSES.keys())
def test_without_an_address_there_is_no_cluster(address, monkeypatch):
    monkeypatch.delenv("RAY_ADDRESS", raising=False)
    if address is not None:
        monkeypatch.setenv("RAY_ADDRESS", address)
    with pytest.raises(InvalidValue, match="expected host:port of a running Ray"):
        list(Workers(2, "ray").map(square, range(2)))


def test_where_nothing_listens_there_is_no_cluster_and_no_waiting(monkeypatch):
    with socket.socket() as closed:
        closed.bind(("127.0.0.1", 0))
        monkeypatch.setenv("RAY_ADDRESS", f"127.0.0.1:{closed.getsockname()[1]}")
    began = time.monotonic()
    with pytest.raises(InvalidValue, match="nothing answers"):
        list(Workers(2, "ray").map(square, range(2)))
    assert time.monotonic() - began < 10.0


def test_what_is_no_ray_cluster_is_told_of_in_time(monkeypatch):
    """It takes calls and says nothing; Ray itself would wait for minutes."""
    monkeypatch.setattr(ray_cluster, "_SECONDS_TO_ANSWER", 3.0)
    with socket.socket() as silent:
        silent.bind(("127.0.0.1", 0))
        silent.listen()
        monkeypatch.setenv("RAY_ADDRESS", f"127.0.0.1:{silent.getsockname()[1]}")
        began = time.monotonic()
        with pytest.raises(InvalidValue, match="what answers is none"):
            list(Workers(2, "ray").map(square, range(2)))
    assert time.monotonic() - began < 30.0


def test_a_local_machine_is_not_crowded():
    most = max(8, 4 * os.cpu_count())
    assert Workers(most).jobs == most
    with pytest.raises(InvalidValue, match=f"from 1 to {most}"):
        Workers(most + 1)
    assert Workers(4096, "ray").jobs == 4096


def test_without_ray_the_extra_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "ray", None)
    with pytest.raises(MissingPackage, match=r"pip install 'prospect-mj\[cluster\]'"):
        list(Workers(2, "ray").map(square, range(2)))
