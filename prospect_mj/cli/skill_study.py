"""The command line of the study of the six skills."""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import tyro
from tqdm import tqdm

from prospect_mj.checks import check_integer
from prospect_mj.cli import command_line
from prospect_mj.cli.output import Output
from prospect_mj.recording.config import LARGEST_SEED, GrossMotion
from prospect_mj.recording.workers import Workers
from prospect_mj.sim import gl

if TYPE_CHECKING:
    from prospect_mj.experiment.studies.skill_study import PolicyEpisode, SkillRun

_MOST = 100_000

_Found = TypeVar("_Found")


@dataclass(frozen=True)
class StudyOptions:
    """Success and duration of every action over many presentations."""

    presentations: int = 100
    """Jittered presentations per side of the lid."""
    episodes: int = 200
    """Of a uniformly random policy, every physics step of which is audited."""
    gross_motion: GrossMotion = "harmonic"
    """How large movements go."""
    jobs: int = 2
    """Processes side by side."""
    seed: int = 0
    """First of the presentations' seeds."""
    output: Annotated[Output, tyro.conf.arg(name="")] = field(default_factory=Output)
    """What is printed."""

    def __post_init__(self) -> None:
        """Refuse a study of nothing."""
        for name in ("presentations", "episodes"):
            check_integer(name, getattr(self, name), 1, _MOST)
        check_integer("seed", self.seed, 0, LARGEST_SEED - _MOST)
        Workers(self.jobs)


def main(argv: Sequence[str] | None = None, prog: str = "skill_study.py") -> int:
    """Run the study as the command line says, and print its tables.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    return command_line.main(_study, StudyOptions(), prog, argv)


def _study(options: StudyOptions) -> None:
    gl.require_gl()
    # MuJoCo is not loaded before it is known that it can render.
    from prospect_mj.experiment.studies import skill_study

    runs = _counted(
        skill_study.run_skills, options.presentations, "presentation", options
    )
    actions = skill_study.summarise(runs)
    failed = [run for run in runs if not run.passed]
    options.output.say(_table(actions, runs))
    episodes = _counted(
        skill_study.run_random_policy, options.episodes, "episode", options
    )
    policy = _side_effects(episodes)
    figures = {"actions": actions, "failed": failed, "random_policy": policy}
    options.output.result(_policy_words(policy), figures)


def _counted(
    study: Callable[..., list[_Found]], n: int, unit: str, options: StudyOptions
) -> list[_Found]:
    """What a part of the study finds at `n` seeds, with a bar."""
    from prospect_mj.experiment.studies.shares import in_parallel
    from prospect_mj.task.pick_place import TaskSettings

    work = partial(study, TaskSettings(gross_motion=options.gross_motion))
    seeds = range(options.seed, options.seed + n)
    with tqdm(total=n, unit=unit, dynamic_ncols=True, disable=None) as bar:
        return in_parallel(work, seeds, options.jobs, tick=bar.update)


def _table(actions: Sequence[Any], runs: "Sequence[SkillRun]") -> str:
    lines = ["action                           passed   of    mean s   max s"]
    for line in actions:
        numbers = f"{line.passed:6d}{line.runs:6d}"
        seconds = f"{line.mean_seconds:9.2f}{line.max_seconds:8.2f}"
        lines.append(f"{line.label:32s} {numbers} {seconds}")
    mean = sum(run.sim_seconds for run in runs) / len(runs)
    failures = [f"failed: {run}" for run in runs if not run.passed]
    return "\n".join([*lines, f"mean of all executed actions: {mean:.2f} s", *failures])


def _side_effects(episodes: "Sequence[PolicyEpisode]") -> dict[str, Any]:
    """What the random policy did besides."""
    contacts: Counter[tuple[str, str]] = Counter()
    saturated: Counter[str] = Counter()
    for episode in episodes:
        contacts += episode.findings.contacts
        saturated += episode.findings.saturated
    return {
        "episodes": len(episodes),
        "jar_lost": [episode.seed for episode in episodes if episode.jar_lost],
        "contacts": {" and ".join(pair): n for pair, n in contacts.items()},
        "saturated": dict(saturated),
        "load": max(episode.findings.load for episode in episodes),
    }


def _policy_words(policy: dict[str, Any]) -> str:
    return "\n".join(
        [
            f"{policy['episodes']} episodes of a random policy",
            f"  jar lost in: {policy['jar_lost'] or 'none'}",
            f"  unintended contacts: {policy['contacts'] or 'none'}",
            f"  saturated actuators: {policy['saturated'] or 'none'}",
            f"  largest share of a torque limit: {policy['load']:.0%}",
        ]
    )
