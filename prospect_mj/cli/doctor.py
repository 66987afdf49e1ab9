"""The command line that tells what is wrong with a machine, and how to mend it."""

import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Annotated

import tyro
from tqdm import tqdm

from prospect_mj.cli import command_line
from prospect_mj.cli.output import Output
from prospect_mj.experiment.doctor import examination
from prospect_mj.experiment.doctor.check import Check, Level


@dataclass(frozen=True)
class DoctorOptions:
    """Look at packages, cores, OpenGL, speed, recording, folders, display and viewer.

    Each line says OK, WARN or FAIL and what to do about it. The exit code is 1 if
    anything fails, else 0.
    """

    output: Annotated[Output, tyro.conf.arg(name="")] = field(default_factory=Output)
    """What is printed."""


def main(argv: Sequence[str] | None = None, prog: str = "doctor.py") -> int:
    """Look at everything, and tell what was found.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code: 1 if something fails; else see `command_line.run`.
    """
    checks: list[Check] = []
    code = command_line.main(
        lambda options: checks.extend(_examine(options.output)),
        DoctorOptions(),
        prog,
        argv,
    )
    return code or int(any(one.level is Level.FAIL for one in checks))


def _examine(output: Output) -> list[Check]:
    checks: list[Check] = []
    with tqdm(
        total=len(examination.LOOKS),
        unit="look",
        leave=False,
        dynamic_ncols=True,
        disable=None,
    ) as bar:
        for name, found in examination.examine():
            bar.set_description_str(name)
            for check in found:
                checks.append(check)
                if not output.json:
                    bar.write(str(check), file=sys.stdout)
                    sys.stdout.flush()
            bar.update()
    well = all(one.level is not Level.FAIL for one in checks)
    output.result(examination.verdict(checks), {"ok": well, "checks": checks})
    return checks
