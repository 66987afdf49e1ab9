"""The command line of the study of the six skills."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from prospect_mj.cli import command_line
from prospect_mj.errors import InvalidValue
from prospect_mj.recording.config import GrossMotion
from prospect_mj.sim import gl


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
    """Processes."""
    seed: int = 0
    """First of the presentations' seeds."""

    def __post_init__(self) -> None:
        """Refuse a study of nothing."""
        limits = {"presentations": 100_000, "episodes": 100_000, "jobs": 256}
        for name, most in limits.items():
            if not 1 <= getattr(self, name) <= most:
                raise InvalidValue(name, getattr(self, name), f"1 to {most}")
        if self.seed < 0:
            raise InvalidValue("seed", self.seed, "0 or more")


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
    print(_skills(options))
    print(_episodes(options))


def _skills(options: StudyOptions) -> str:
    from prospect_mj.experiment import skill_study
    from prospect_mj.task.pick_place import TaskSettings

    runs = skill_study.skills_in_parallel(
        TaskSettings(gross_motion=options.gross_motion),
        options.presentations,
        options.jobs,
        options.seed,
    )
    lines = ["action                           passed   of    mean s   max s"]
    for line in skill_study.summarise(runs):
        numbers = f"{line.passed:6d}{line.runs:6d}"
        seconds = f"{line.mean_seconds:9.2f}{line.max_seconds:8.2f}"
        lines.append(f"{line.label:32s} {numbers} {seconds}")
    mean = sum(run.sim_seconds for run in runs) / len(runs)
    failures = [f"failed: {run}" for run in runs if not run.passed]
    return "\n".join([*lines, f"mean of all executed actions: {mean:.2f} s", *failures])


def _episodes(options: StudyOptions) -> str:
    from prospect_mj.experiment import skill_study
    from prospect_mj.task.pick_place import TaskSettings

    episodes = skill_study.random_policy_in_parallel(
        TaskSettings(gross_motion=options.gross_motion),
        options.episodes,
        options.jobs,
        options.seed,
    )
    contacts: Counter[tuple[str, str]] = Counter()
    saturated: Counter[str] = Counter()
    for episode in episodes:
        contacts += episode.findings.contacts
        saturated += episode.findings.saturated
    lost = [episode.seed for episode in episodes if episode.jar_lost]
    load = max(episode.findings.load for episode in episodes)
    return "\n".join(
        [
            f"{len(episodes)} episodes of a random policy",
            f"  jar lost in: {lost or 'none'}",
            f"  unintended contacts: {dict(contacts) or 'none'}",
            f"  saturated actuators: {dict(saturated) or 'none'}",
            f"  largest share of a torque limit: {load:.0%}",
        ]
    )
