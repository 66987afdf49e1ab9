"""The command line of the benchmark."""

from collections.abc import Sequence

from prospect_mj.cli import command_line
from prospect_mj.experiment.bench import BenchConfig, bench


def main(argv: Sequence[str] | None = None, prog: str = "bench.py") -> int:
    """Measure as the command line says, and print the figures.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    return command_line.main(_measure, BenchConfig(), prog, argv)


def _measure(config: BenchConfig) -> None:
    print(bench(config).report())
