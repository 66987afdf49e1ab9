"""Work spread over processes by joblib: local ones, or those of a Ray cluster."""

import os
import time
import warnings
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from functools import cache
from threading import Thread
from typing import Any, Literal, TypeVar, get_args

import joblib

from prospect_mj.checks import check_choice, check_integer
from prospect_mj.recording import ray_cluster

Backend = Literal["local", "ray"]
Mapper = Callable[[Callable[[Any], Any], Iterable[Any]], Iterable[Any]]
"""Like `map`, but for the order: results as they are ready."""

_MOST_JOBS = 4096
_MOST_LOCAL_JOBS = max(8, 4 * (os.cpu_count() or 1))
"""More would wait for each other, and each needs some 300 MB."""
_EVERY = 0.5
"""Between two looks at the process that started this one [s]."""

_Given = TypeVar("_Given")
_Made = TypeVar("_Made")


@dataclass(frozen=True)
class Workers:
    """Where work is done."""

    jobs: int = 2
    """Processes side by side."""
    backend: Backend = "local"
    """local: processes of this machine; ray: of an existing Ray cluster, whose address
    is in RAY_ADDRESS (needs the extra `cluster`)."""

    def __post_init__(self) -> None:
        """Refuse what can't work."""
        check_choice("backend", self.backend, get_args(Backend))
        most = _MOST_LOCAL_JOBS if self.backend == "local" else _MOST_JOBS
        check_integer("jobs", self.jobs, 1, most)

    def check(self) -> None:
        """Refuse what is not there, before anything is begun.

        Raises:
            ProspectError: as `mapper`, but for the size of a cluster.
        """
        if self.backend == "ray":
            ray_cluster.check()

    @contextmanager
    def mapper(self) -> Iterator[Mapper]:
        """Open the processes; they stay for everything that is mapped.

        Yields:
            What applies a function, importable by name, to each of its arguments. On
            Ray the results come together, once all are ready: joblib's backend for it
            has no other way.

        Raises:
            MissingPackage: if Ray is wanted, and not installed.
            InvalidValue: if no Ray cluster can be joined at RAY_ADDRESS, or it is too
                small.
            ChildProcessError: if a process was lost, or Ray failed.
        """
        returned = "list" if self.backend == "ray" else "generator_unordered"
        parent = None if self.backend == "ray" else os.getpid()
        with self._backend(), _told_plainly():
            # Processes of other machines can't read what joblib would put on disk.
            parallel = joblib.Parallel(
                self.jobs, return_as=returned, pre_dispatch="all", max_nbytes=None
            )
            with parallel:
                yield lambda function, items: parallel(
                    joblib.delayed(_applied)(function, item, parent) for item in items
                )

    def map(
        self, function: Callable[[_Given], _Made], items: Iterable[_Given]
    ) -> Iterator[_Made]:
        """Results of a function, as `mapper` gives them, on processes opened for it.

        Args:
            function: importable by name.
            items: its arguments.

        Raises:
            ProspectError, ChildProcessError: as `mapper`.
        """
        with self.mapper() as mapped:
            yield from mapped(function, items)

    def _backend(self) -> AbstractContextManager[object]:
        if self.backend == "ray":
            return ray_cluster.connected(self.jobs)
        return joblib.parallel_config("loky")


def _applied(
    function: Callable[[_Given], _Made], item: _Given, parent: int | None
) -> _Made:
    if parent is not None:
        end_with(parent)
    return function(item)


@cache
def end_with(parent: int) -> None:
    """Let this process end when that which started it was killed, or if it was.

    It would go on with its work and hold its folders, so that the same command again
    could not go on.

    Args:
        parent: the process that started this one, or is this one.
    """
    if os.getpid() != parent:
        Thread(target=_outlive, args=(parent,), daemon=True).start()


def _outlive(parent: int) -> None:
    while os.getppid() == parent:
        time.sleep(_EVERY)
    os._exit(1)


@contextmanager
def _told_plainly() -> Iterator[None]:
    try:
        with warnings.catch_warnings():
            # Joblib complains of work that an interruption leaves undone.
            warnings.filterwarnings("ignore", r"\d+ tasks which were", UserWarning)
            yield
    except BrokenExecutor as error:
        raise ChildProcessError(
            "a worker process was killed, or ran out of memory"
        ) from error
