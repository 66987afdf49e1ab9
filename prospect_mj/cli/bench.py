"""The command line of the benchmark: of the simulation, and of the learners."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Annotated

import tyro
from tqdm import tqdm

from prospect_mj.cli import command_line
from prospect_mj.cli.output import Output
from prospect_mj.experiment.populations.costs import measured_costs, table
from prospect_mj.experiment.studies.bench import BenchConfig, bench
from prospect_mj.recording.recording import Recording


@dataclass(frozen=True)
class BenchOptions:
    """Measure simulated seconds per wall second, and where the wall time goes.

    Then what each learner costs on recorded physics, beside the linear one.
    """

    config: Annotated[BenchConfig, tyro.conf.arg(name="")] = field(
        default_factory=BenchConfig
    )
    """What to measure."""
    output: Annotated[Output, tyro.conf.arg(name="")] = field(default_factory=Output)
    """What is printed."""


def main(argv: Sequence[str] | None = None, prog: str = "bench.py") -> int:
    """Measure as the command line says, and print the figures.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    return command_line.main(_measure, BenchOptions(), prog, argv)


def _measure(options: BenchOptions) -> None:
    config = options.config
    with tqdm(
        total=config.trials, unit="trial", dynamic_ncols=True, disable=None
    ) as bar:
        found = bench(config, bar.update)
    costs = measured_costs(Recording.load())
    learners = {"learners": [cost._asdict() for cost in costs]}
    words = f"{found.report()}\n\n{table(costs)}"
    options.output.result(words, found.figures() | learners)
