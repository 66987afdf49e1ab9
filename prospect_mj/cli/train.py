"""The command line of a training run."""

import sys
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Annotated

import tyro

from prospect_mj.agent import LearnerSettings
from prospect_mj.cli import command_line
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment import session
from prospect_mj.experiment.config import TrainConfig
from prospect_mj.experiment.environment import MakeEnvironment, make_environment
from prospect_mj.experiment.kept_episodes import Kept
from prospect_mj.experiment.run_folder import read_config


@dataclass(frozen=True)
class TrainOptions:
    """Train the Q-learner on live or recorded physics and write a run folder."""

    config: Annotated[TrainConfig, tyro.conf.arg(name="")] = field(
        default_factory=TrainConfig
    )
    """The run."""
    out: Path | None = None
    """Folder of a new run; it must be new or empty. Default: the first free one of
    runs/train-0001, runs/train-0002, ..."""
    resume: Path | None = None
    """Folder of a run to continue exactly where it stopped; of the other options only
    a larger --trials may differ from that run's, and --record."""
    record: str | None = None
    """Which trials are kept for replay.py, in episodes/ of the run: all, failures, or
    every=N. Results are the same with it and without."""


def main(
    argv: Sequence[str] | None = None,
    prog: str = "train.py",
    make_env: MakeEnvironment = make_environment,
) -> int:
    """Train as the command line says.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.
        make_env: makes the environment.

    Returns:
        The exit code; see `command_line.run`.
    """
    arguments = sys.argv[1:] if argv is None else argv
    return command_line.run(
        lambda: _train(arguments, prog, make_env),
        interrupted="interrupted: all finished trials are kept",
    )


def _train(argv: Sequence[str], prog: str, make_env: MakeEnvironment) -> None:
    options = _parse(argv, prog, TrainOptions())
    kept = None if options.record is None else Kept.parse(options.record)
    if kept is not None and options.config.physics != "live":
        raise InvalidValue("--record", options.record, "none on recorded physics")
    if options.resume is None:
        summary = session.start(options.config, options.out, make_env, kept=kept)
    else:
        if options.out is not None:
            raise InvalidValue("--out", str(options.out), "none beside --resume")
        # Options that are not given keep the stored run's values.
        stored = replace(options, config=read_config(options.resume))
        config = _parse(argv, prog, stored).config
        summary = session.resume(options.resume, config, make_env, kept=kept)
    if summary is not None:
        print(summary)


def _parse(argv: Sequence[str], prog: str, default: TrainOptions) -> TrainOptions:
    return command_line.parse(
        TrainOptions, argv, default=default, prog=prog, registry=_REGISTRY
    )


_REGISTRY = tyro.constructors.ConstructorRegistry()

_LEARNER_OPTIONS = {
    "step_size": "alpha of the paper's update.",
    "epsilon": "Probability of an action chosen at random.",
    "discount": "gamma of the paper's update, per action.",
    "initial_sd": "Standard deviation of the initial weights; 0: they are zero.",
}


@_REGISTRY.struct_rule
def _learner_rule(
    info: tyro.constructors.StructTypeInfo,
) -> tyro.constructors.StructConstructorSpec | None:
    """Offer the learner's parameters but not its sizes, which the task fixes."""
    if info.type is not LearnerSettings:
        return None
    default = info.default
    if not isinstance(default, LearnerSettings):
        default = LearnerSettings()
    return tyro.constructors.StructConstructorSpec(
        instantiate=LearnerSettings,
        fields=tuple(
            tyro.constructors.StructFieldSpec(
                name=name,
                type=float,
                default=getattr(default, name),
                helptext=meaning,
            )
            for name, meaning in _LEARNER_OPTIONS.items()
        ),
    )
