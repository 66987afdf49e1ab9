"""An existing Ray cluster as joblib's backend."""

import logging
import os
import re
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import ModuleType

import joblib

from prospect_mj.errors import InvalidValue, MissingPackage

ADDRESS = "RAY_ADDRESS"
"""Environment variable with the address of the cluster's head."""
_SECONDS_TO_LISTEN = 5.0
_SECONDS_TO_ANSWER = 20.0
"""Most of them for starting Ray's own command on a busy machine."""
_EXPECTED = "host:port of a running Ray cluster"


@contextmanager
def connected(jobs: int) -> Iterator[None]:
    """Let joblib work on the cluster at RAY_ADDRESS.

    Args:
        jobs: processes that it must have room for.

    Raises:
        MissingPackage: if Ray is not installed.
        InvalidValue: if there is no cluster, it can't be joined or is too small, or if
            this process is in one already.
        ChildProcessError: if a process of the cluster was lost, or Ray failed.
    """
    address, ray = check(), _ray()
    if ray.is_initialized():
        expected = "one that this process is not connected to yet"
        raise InvalidValue("Ray cluster", address, expected)
    from ray.util.joblib import register_ray

    register_ray()
    try:
        _join(ray, address)
        n_cpus = int(ray.cluster_resources().get("CPU", 0))
        if jobs > n_cpus:
            raise InvalidValue("jobs", jobs, f"at most {n_cpus}, the cluster's CPUs")
        with joblib.parallel_config("ray"):
            yield
    except ray.exceptions.RayError as error:
        raise ChildProcessError(_told(ray, error)) from error
    finally:
        ray.shutdown()


def check() -> str:
    """Refuse to go on without a cluster; Ray itself would try for many minutes.

    Returns:
        Its address.

    Raises:
        MissingPackage: if Ray is not installed.
        InvalidValue: if there is no cluster.
    """
    _ray()
    address = os.environ.get(ADDRESS)
    found = re.fullmatch(r"(\[[^]]+\]|[^:/]+):(\d{1,5})", address or "")
    if found is None:
        raise InvalidValue(ADDRESS, address, _EXPECTED)
    host, port = found[1].strip("[]"), int(found[2])
    try:
        socket.create_connection((host, port), _SECONDS_TO_LISTEN).close()
    except (OSError, OverflowError) as error:
        raise InvalidValue(ADDRESS, address, f"{_EXPECTED}; nothing answers") from error
    if not _is_healthy(address):
        raise InvalidValue(ADDRESS, address, f"{_EXPECTED}; what answers is none")
    return address


def _ray() -> ModuleType:
    try:
        import ray
    except ImportError as error:
        raise MissingPackage("ray", "cluster") from error
    return ray


def _is_healthy(address: str) -> bool:
    """Whether a Ray head says that it is there, within a time."""
    command = "-m", "ray.scripts.scripts", "health-check", "--address", address
    try:
        done = subprocess.run(
            [sys.executable, *command],
            capture_output=True,
            timeout=_SECONDS_TO_ANSWER,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return False
    return done.returncode == 0


def _join(ray: ModuleType, address: str) -> None:
    try:
        ray.init(address, log_to_driver=False, logging_level=logging.ERROR)
    except (RuntimeError, ConnectionError) as error:
        # Such as of other versions of Ray and Python; the cause tells which.
        reason = error if error.__cause__ is None else error.__cause__
        expected = f"a Ray cluster that can be joined; {reason}"
        raise InvalidValue(ADDRESS, address, expected) from error


def _told(ray: ModuleType, error: Exception) -> str:
    """What went wrong in the cluster, in a line."""
    lost = (
        ray.exceptions.NodeDiedError,
        ray.exceptions.OutOfMemoryError,
        ray.exceptions.RayActorError,
        ray.exceptions.WorkerCrashedError,
    )
    if isinstance(error, lost):
        return "a process of the Ray cluster was lost"
    words = str(error).strip() or type(error).__name__
    return f"Ray failed: {words.splitlines()[-1]}"
