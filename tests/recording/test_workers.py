"""Work in other processes; the Ray cluster is in test_ray.py."""

import os
import signal
import socket
import sys
import time
from functools import partial

import pytest

from prospect_mj.errors import InvalidValue, MissingPackage
from prospect_mj.recording import ray_cluster
from prospect_mj.recording.workers import Workers


def square(number):
    return number**2, os.getpid()


def met(folder, number):
    """Come back only after the other one has; the first, after that."""
    if number == 0:
        until = time.monotonic() + 60
        while not (folder / "1").exists() and time.monotonic() < until:
            time.sleep(0.01)
    (folder / str(number)).touch()
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
    """The first piece of work waits for the second, however late that begins."""
    assert list(Workers(2).map(partial(met, tmp_path), [0, 1])) == [1, 0]


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
