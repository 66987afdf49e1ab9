"""Work spread over processes by joblib: local ones, or those of a Ray cluster."""

from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from typing import Literal, TypeVar, get_args

import joblib

from prospect_mj.agent.checks import check_integer
from prospect_mj.errors import InvalidChoice, MissingPackage

Backend = Literal["local", "ray"]

_Given = TypeVar("_Given")
_Made = TypeVar("_Made")


@dataclass(frozen=True)
class Workers:
    """Where work is done."""

    jobs: int = 2
    """Processes."""
    backend: Backend = "local"
    """local: processes of this machine; ray: of an existing Ray cluster, whose address
    is in RAY_ADDRESS (needs the extra `cluster`)."""

    def __post_init__(self) -> None:
        """Refuse what can't work."""
        check_integer("jobs", self.jobs, 1, 4096)
        if self.backend not in get_args(Backend):
            raise InvalidChoice("backend", self.backend, get_args(Backend))

    def map(
        self, function: Callable[[_Given], _Made], items: Iterable[_Given]
    ) -> Iterator[_Made]:
        """Results of a function, as they are ready.

        Args:
            function: importable by name.
            items: its arguments.
        """
        with self._context():
            yield from joblib.Parallel(
                n_jobs=self.jobs, return_as="generator_unordered", pre_dispatch="all"
            )(joblib.delayed(function)(item) for item in items)

    def _context(self) -> AbstractContextManager[object]:
        if self.backend == "local":
            return joblib.parallel_config("loky") if self.jobs > 1 else nullcontext()
        return _ray()


def _ray() -> AbstractContextManager[object]:
    try:
        from ray.util.joblib import register_ray
    except ImportError as error:
        raise MissingPackage("ray", "cluster") from error
    register_ray()
    return joblib.parallel_config("ray")
