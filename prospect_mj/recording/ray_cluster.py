"""An existing Ray cluster as joblib's backend."""

import logging
import os
import re
import socket
from collections.abc import Iterator
from contextlib import contextmanager

import joblib

from prospect_mj.errors import InvalidValue, MissingPackage

ADDRESS = "RAY_ADDRESS"
"""Environment variable with the address of the cluster's head."""
_SECONDS_TO_ANSWER = 5.0


@contextmanager
def connected(jobs: int) -> Iterator[None]:
    """Let joblib work on the cluster at RAY_ADDRESS.

    Args:
        jobs: processes that it must have room for.

    Raises:
        MissingPackage: if Ray is not installed.
        InvalidValue: if there is no cluster, or it is too small.
        ChildProcessError: if a process of the cluster was lost.
    """
    try:
        import ray
        from ray.util.joblib import register_ray
    except ImportError as error:
        raise MissingPackage("ray", "cluster") from error
    address = _answering()
    register_ray()
    try:
        ray.init(address, log_to_driver=False, logging_level=logging.ERROR)
        n_cpus = int(ray.cluster_resources().get("CPU", 0))
        if jobs > n_cpus:
            raise InvalidValue("jobs", jobs, f"at most {n_cpus}, the cluster's CPUs")
        with joblib.parallel_config("ray"):
            yield
    except ray.exceptions.RayError as error:
        raise ChildProcessError("a process of the Ray cluster was lost") from error
    finally:
        ray.shutdown()


def _answering() -> str:
    """The address, if anything listens there; Ray itself would try for many minutes."""
    address = os.environ.get(ADDRESS)
    expected = "host:port of a running Ray cluster"
    found = re.fullmatch(r"(\[[^]]+\]|[^:/]+):(\d{1,5})", address or "")
    if found is None:
        raise InvalidValue(ADDRESS, address, expected)
    host, port = found[1].strip("[]"), int(found[2])
    try:
        socket.create_connection((host, port), _SECONDS_TO_ANSWER).close()
    except (OSError, OverflowError) as error:
        raise InvalidValue(ADDRESS, address, f"{expected}; nothing answers") from error
    return address
