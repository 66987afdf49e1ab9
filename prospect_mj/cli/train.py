"""The command line of a training run."""

import sys
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Annotated

import tyro

from prospect_mj.cli import command_line
from prospect_mj.cli.learner_options import learner_registry, with_learner
from prospect_mj.cli.output import Output
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import MakeEnvironment, make_environment
from prospect_mj.experiment.run.kept_episodes import Kept
from prospect_mj.experiment.run.run_folder import RunFolder, read_config
from prospect_mj.experiment.run.summary import Summary
from prospect_mj.recording.workers import Workers


@dataclass(frozen=True)
class TrainOptions:
    """Train a learner on live or recorded physics and write a run folder."""

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
    seeds: str | None = None
    """Several runs at once, one of each seed, in place of --seed: such as 0:8 (0 to 7),
    0:8:2 or 0,3,5. They go to seed-0000, ... in --out (default: runs/seeds); the same
    command again goes on where it was stopped."""
    jobs: int = 2
    """Processes for --seeds."""
    record: str | None = None
    """Which trials are kept for replay, in episodes/ of the run: all, failures, or
    every=N. Results are the same with it and without."""
    output: Annotated[Output, tyro.conf.arg(name="")] = field(default_factory=Output)
    """Who reads the result."""

    def __post_init__(self) -> None:
        """Refuse what can't work."""
        Workers(self.jobs)


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
        "interrupted: all finished trials are kept",
        arguments,
    )


def _train(argv: Sequence[str], prog: str, make_env: MakeEnvironment) -> None:
    options = _parse(argv, prog, TrainOptions())
    kept = None if options.record is None else Kept.parse(options.record)
    if options.resume is None:
        _check_keepable(options.record, options.config)
    if options.seeds is not None:
        _check_alone(options, argv)
        _train_seeds(options, options.seeds, make_env, kept)
        return
    say = options.output.say
    if options.resume is None:
        summary = session.start(options.config, options.out, make_env, say, kept)
    else:
        if options.out is not None:
            raise InvalidValue("--out", str(options.out), "none beside --resume")
        # Options that are not given keep the stored run's values; a flag that is on
        # already can't be given.
        stored = replace(options, config=read_config(options.resume), output=Output())
        config = _parse(argv, prog, stored).config
        _check_keepable(options.record, config)
        summary = session.resume(options.resume, config, make_env, say, kept)
        if summary is None and options.output.json:
            summary = _finished(options.resume)
    if summary is not None:
        options.output.result(str(summary), summary)


def _check_keepable(record: str | None, config: TrainConfig) -> None:
    if record is not None and config.physics != "live":
        expected = "none on recorded physics: replay simulates its trials again"
        raise InvalidValue("--record", record, expected)


def _finished(path: Path) -> Summary:
    """What a run came to in which nothing was left to do."""
    with RunFolder.open(path) as folder:
        return Summary.of(folder, folder.n_trials, 0.0)


def _check_alone(options: TrainOptions, argv: Sequence[str]) -> None:
    """Refuse what contradicts --seeds; a seed may be given that is the default one."""
    if any(word.partition("=")[0] == "--seed" for word in argv):
        raise InvalidValue("--seed", options.config.seed, "none beside --seeds")
    if options.resume is not None:
        expected = "none beside --seeds, which goes on by itself"
        raise InvalidValue("--resume", str(options.resume), expected)
    if options.config.grow and options.jobs > 1:
        expected = "1 beside --grow: one process at a time can grow a recording"
        raise InvalidValue("--jobs", options.jobs, expected)


def _train_seeds(
    options: TrainOptions, seeds: str, make_env: MakeEnvironment, kept: Kept | None
) -> None:
    # Only here: it loads the libraries that draw the paper's figures.
    from prospect_mj.experiment.seeds.seed_list import parse_seeds
    from prospect_mj.experiment.seeds.seeds_folder import (
        CURVES,
        DEFAULT,
        FIGURES,
        SUMMARY,
    )
    from prospect_mj.experiment.seeds.train_seeds import train_seeds

    out = DEFAULT if options.out is None else options.out
    numbers = parse_seeds(seeds)
    output = options.output
    summary = train_seeds(
        options.config, numbers, out, options.jobs, make_env, output.say, kept
    )
    told = f"folder {out}: a run folder for each seed, {SUMMARY}, {FIGURES}, {CURVES}"
    output.result(f"{summary}\n{told}", summary)


def _parse(argv: Sequence[str], prog: str, default: TrainOptions) -> TrainOptions:
    default = replace(default, config=with_learner(default.config, argv))
    registry = learner_registry()
    return command_line.parse(
        TrainOptions, argv, default=default, prog=prog, registry=registry
    )
