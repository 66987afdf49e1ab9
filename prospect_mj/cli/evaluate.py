"""The command line that evaluates the policy of a run."""

import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import tyro

from prospect_mj.cli import command_line
from prospect_mj.cli.output import Output
from prospect_mj.errors import InvalidValue, ProspectError
from prospect_mj.experiment.evaluation.evaluate import evaluate
from prospect_mj.experiment.evaluation.report import Report
from prospect_mj.experiment.evaluation.text import text
from prospect_mj.experiment.run.environment import MakeEnvironment, make_environment
from prospect_mj.experiment.run.kept_episodes import Kept
from prospect_mj.experiment.view.evaluation_settings import EvaluationSettings
from prospect_mj.experiment.view.run_view import RunView


@dataclass(frozen=True)
class EvaluateOptions:
    """Evaluate the greedy policy of a run on presentations that no training has shown.

    The same command again goes on where it was stopped. A run that is under way is
    evaluated as far as it has come.
    """

    run: Annotated[Path, tyro.conf.Positional, tyro.conf.arg(metavar="RUN")]
    """The run's folder."""
    settings: Annotated[EvaluationSettings, tyro.conf.arg(name="")] = field(
        default_factory=EvaluationSettings
    )
    """What is shown."""
    out: Path | None = None
    """Folder of the evaluation: new, empty, or of the same one. Default: the first of
    RUN/evaluations/0001, 0002, ... that is free or has it begun."""
    record: str | None = None
    """Which trials are kept for replay: all, failures, or every=N. Default: failures on
    live physics; recorded physics has nothing to keep."""
    longer: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False
    """List also the solved trials that took more than two actions, the optimum."""
    output: Annotated[Output, tyro.conf.arg(name="")] = field(default_factory=Output)
    """Who reads the result."""

    @property
    def kept(self) -> Kept | None:
        """Which trials are kept as episodes.

        Raises:
            InvalidValue: if --record is none, or there is nothing to keep.
        """
        if self.settings.physics == "live":
            return Kept.parse(self.record or "failures")
        if self.record is not None:
            raise InvalidValue("--record", self.record, "none on recorded physics")
        return None


def main(
    argv: Sequence[str] | None = None,
    prog: str = "evaluate.py",
    make_env: MakeEnvironment = make_environment,
) -> int:
    """Evaluate what the command line names.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.
        make_env: makes the environment.

    Returns:
        The exit code; see `command_line.run`.
    """
    return command_line.main(
        lambda options: _evaluate(options, make_env),
        EvaluateOptions(tyro.MISSING),
        prog,
        argv,
        "interrupted: all finished trials are kept",
    )


def _evaluate(options: EvaluateOptions, make_env: MakeEnvironment) -> None:
    kept, output = options.kept, options.output
    run = RunView.read(options.run)
    if options.settings.physics == run.config.physics:
        _warn_if_outdated(run)
    view = evaluate(run, options.settings, options.out, make_env, output.say, kept)
    report = Report.of(view)
    output.result(text(report, options.longer), report)


def _warn_if_outdated(run: RunView) -> None:
    """The physics, or the recording, that it learned on may be another by now."""
    try:
        changed = run.outdated()
    except ProspectError as error:
        changed = [str(error)]
    if changed:
        words = f"{run.path} learned before a change of {', '.join(changed)}"
        warnings.warn(words, stacklevel=2)
