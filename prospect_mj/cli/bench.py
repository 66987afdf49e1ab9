"""The command line of the benchmark."""

import sys
from collections.abc import Sequence

from prospect_mj.cli import command_line
from prospect_mj.experiment.bench import BenchConfig, bench


def main(argv: Sequence[str] | None = None) -> int:
    """Measure as the command line says, and print the figures.

    Returns:
        The exit code: 0, 2 for input that can't be used, 1 for any other failure.
    """
    arguments = sys.argv[1:] if argv is None else argv

    def measure() -> None:
        config = command_line.parse(BenchConfig, arguments, BenchConfig(), "bench.py")
        print(bench(config).report())

    return command_line.run(measure)
