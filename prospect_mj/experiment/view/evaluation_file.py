"""evaluation.yaml: what was evaluated, on what, and which software did it."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any, TypeVar

import yaml

from prospect_mj.checks import check_integer, check_names
from prospect_mj.errors import ProspectError, RunFolderError
from prospect_mj.experiment.run import config_file, fingerprint
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.config_file import StoredConfig
from prospect_mj.experiment.view.evaluation_settings import EvaluationSettings
from prospect_mj.recording.provenance import sha256
from prospect_mj.storage import read_yaml, replace_file

NAME = "evaluation.yaml"

_MARK, _FORMAT = "prospect_mj_evaluation", 1
_EVALUATION = "evaluation"
_Settings = TypeVar("_Settings")


@dataclass(frozen=True)
class Learned:
    """The learner that is evaluated: that of a run, as far as it had come."""

    origin: str
    """Digest that marks the run's files."""
    trials: int
    """Its finished trials then."""

    def __post_init__(self) -> None:
        """Refuse what no run has come to."""
        check_integer("trials of the run", self.trials, 1, 10**9)


@dataclass(frozen=True)
class StoredEvaluation:
    """What an evaluation is, as it was written."""

    settings: EvaluationSettings
    learned: Learned
    stored: StoredConfig
    """Settings, digests and versions of its trials."""

    @property
    def config(self) -> TrainConfig:
        """The settings of its trials.

        Raises:
            ProspectError: if this version doesn't know them.
        """
        return TrainConfig.from_dict(self.stored.settings)

    @property
    def origin(self) -> str:
        """Digest that marks its other files."""
        return fingerprint.origin_of(self.stored.sha256)

    def difference(self, other: "StoredEvaluation") -> str | None:
        """What of another evaluation is not the same; how far the run had come aside.

        Args:
            other: the other one.

        Returns:
            The first difference, in words that tell of `other`; None: there is none.
        """
        if other.learned.origin != self.learned.origin:
            return "of another run"
        for field in fields(self.settings):
            had, wanted = (getattr(e.settings, field.name) for e in (other, self))
            if had != wanted:
                return f"with {field.name} {had}, not {wanted}"
        for name, (had, wanted) in _paired(other.stored, self.stored).items():
            if had != wanted and name != _EVALUATION:
                return f"made with another {name}"
        return None


def is_in(path: Path) -> bool:
    """Whether a folder holds an evaluation."""
    return (path / NAME).is_file()


def present(
    config: TrainConfig, settings: EvaluationSettings, learned: Learned
) -> StoredEvaluation:
    """An evaluation by the software that is installed.

    Args:
        config: settings of its trials.
        settings: of the evaluation.
        learned: what is evaluated.

    Raises:
        ProspectError: if something that decides its numbers is missing.
    """
    stored = config_file.present(config)
    digest = {_EVALUATION: _digest(_identity(settings, learned))}
    marked = replace(stored, sha256={**stored.sha256, **digest})
    return StoredEvaluation(settings, learned, marked)


def write(folder: Path, evaluation: StoredEvaluation) -> None:
    """Write what an evaluation is, all or nothing."""
    identity = _identity(evaluation.settings, evaluation.learned)
    stored = config_file.as_content(evaluation.stored)
    content = {_MARK: _FORMAT, _EVALUATION: identity, **stored}
    replace_file(folder / NAME, yaml.safe_dump(content, sort_keys=False).encode())


def read(folder: Path) -> StoredEvaluation:
    """Read what an evaluation is.

    Raises:
        RunFolderError: if there is none, or it is unreadable, foreign or edited.
    """
    path = folder / NAME
    content = read_yaml(path, RunFolderError)
    if content.get(_MARK) != _FORMAT:
        raise RunFolderError(f"{path} is not the description of an evaluation")
    stored = config_file.stored_in(path, content)
    try:
        identity = content[_EVALUATION]
        if stored.sha256[_EVALUATION] != _digest(identity):
            raise RunFolderError(f"{path}: its settings were edited")
        return StoredEvaluation(
            _understood(identity["settings"], EvaluationSettings),
            _understood(identity["learned"], Learned),
            stored,
        )
    except RunFolderError:
        raise
    except (ProspectError, KeyError, TypeError) as error:
        raise RunFolderError(f"{path} is damaged: {error}") from error


def _understood(plain: Mapping[str, Any], settings: type[_Settings]) -> _Settings:
    check_names(plain, settings)
    return settings(**plain)


def _paired(a: StoredConfig, b: StoredConfig) -> dict[str, tuple[object, object]]:
    """Versions and digests of both, by name."""
    had, wanted = ({**one.versions, **one.sha256} for one in (a, b))
    return {name: (had.get(name), wanted.get(name)) for name in {**wanted, **had}}


def _identity(settings: EvaluationSettings, learned: Learned) -> dict[str, Any]:
    return {"settings": asdict(settings), "learned": asdict(learned)}


def _digest(identity: object) -> str:
    return sha256(json.dumps(identity, sort_keys=True).encode())
