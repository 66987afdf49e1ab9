"""The study of the six skills: success, time and side effects over many presentations.

Two sequences per presentation bring every action to its proper state by actions alone:
the hand on the lid's side grasps and inserts; the other hand grasps, tries to insert
the wrong way round, hands the jar over, and the first hand inserts it.
"""

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.recording.hands import GRASPS, INSERTIONS, NUMBERS, SWAPS
from prospect_mj.robot import names
from prospect_mj.robot.names import Side
from prospect_mj.sim.audit import Audit, Findings
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings
from prospect_mj.task.presentation import ORIENTATIONS, Orientation


@dataclass(frozen=True)
class SkillRun:
    """One action of the study."""

    seed: int
    orientation: Orientation
    action: Action
    wrong_way: bool
    """Whether it is an insertion that cannot fit."""
    result: ActionResult
    passed: bool
    """Whether it ended as physics allows: success, or a jam with the jar in hand."""
    sim_seconds: float


@dataclass(frozen=True)
class SkillSummary:
    """One line of the study's table."""

    label: str
    runs: int
    passed: int
    mean_seconds: float
    max_seconds: float


def sequences(orientation: Orientation) -> tuple[tuple[Action, ...], ...]:
    """The two sequences of actions for a side of the lid."""
    good, bad = NUMBERS[orientation], NUMBERS[names.other(orientation)]
    return (
        (GRASPS[good], INSERTIONS[good]),
        (GRASPS[bad], INSERTIONS[bad], SWAPS[bad], INSERTIONS[good]),
    )


def run_skills(settings: TaskSettings, seeds: Iterable[int]) -> list[SkillRun]:
    """Both sequences at both orientations for each presentation seed."""
    runs = []
    with PickPlaceTask(settings) as task:
        for seed in seeds:
            for orientation in ORIENTATIONS:
                for sequence in sequences(orientation):
                    task.reset(orientation, np.random.default_rng(seed))
                    runs += _follow(task, seed, orientation, sequence)
    return runs


def _follow(
    task: PickPlaceTask,
    seed: int,
    orientation: Orientation,
    sequence: tuple[Action, ...],
) -> list[SkillRun]:
    """Run a sequence up to its first action that does not end as it should."""
    runs = []
    for action in sequence:
        holder = task.holder
        outcome = task.execute(action)
        insertion = action in INSERTIONS.values()
        wrong_way = insertion and action is not INSERTIONS[NUMBERS[orientation]]
        passed = _passed(task, outcome.result, insertion, wrong_way, holder)
        runs.append(
            SkillRun(
                seed,
                orientation,
                action,
                wrong_way,
                outcome.result,
                passed,
                outcome.sim_seconds,
            )
        )
        if not passed:
            break
    return runs


def _passed(
    task: PickPlaceTask,
    result: ActionResult,
    insertion: bool,
    wrong_way: bool,
    holder: Side | None,
) -> bool:
    if wrong_way:
        return result is ActionResult.JAMMED and task.holder == holder
    if insertion:
        return result is ActionResult.SUCCESS and task.inserted
    return result is ActionResult.SUCCESS and task.holder is not None


def summarise(runs: Iterable[SkillRun]) -> list[SkillSummary]:
    """A line for each action, wrong-way insertions apart."""
    groups: dict[str, list[SkillRun]] = defaultdict(list)
    for run in runs:
        suffix = " (wrong way)" if run.wrong_way else ""
        groups[run.action.label + suffix].append(run)
    return [_line(label, groups[label]) for label in sorted(groups)]


def _line(label: str, runs: list[SkillRun]) -> SkillSummary:
    seconds = [run.sim_seconds for run in runs]
    passed = sum(run.passed for run in runs)
    return SkillSummary(
        label, len(runs), passed, float(np.mean(seconds)), float(np.max(seconds))
    )


@dataclass(frozen=True)
class PolicyEpisode:
    """One episode of a uniformly random policy."""

    seed: int
    results: tuple[str, ...]
    """Of the executed actions."""
    jar_lost: bool
    findings: Findings


def run_random_policy(
    settings: TaskSettings, seeds: Iterable[int], max_actions: int = 10
) -> list[PolicyEpisode]:
    """Episodes of uniformly random actions, with an audit of every physics step."""
    episodes = []
    with PickPlaceTask(settings) as task:
        for seed in seeds:
            rng = np.random.default_rng(seed)
            orientation = ORIENTATIONS[int(rng.integers(2))]
            task.reset(orientation, rng)
            audit = _audit(task)
            results = _random_actions(task, rng, max_actions)
            lost = ActionResult.LOST in results
            episodes.append(PolicyEpisode(seed, results, lost, audit.findings))
    return episodes


def _audit(task: PickPlaceTask) -> Audit:
    joints = [joint for side in names.SIDES for joint in names.arm_joints(side)]
    audit = Audit(task.simulation.model, joints)
    task.simulation.observer = audit
    return audit


def _random_actions(
    task: PickPlaceTask, rng: np.random.Generator, max_actions: int
) -> tuple[str, ...]:
    results: list[str] = []
    for _ in range(max_actions):
        outcome = task.execute(Action(int(rng.integers(len(Action)))))
        if outcome.executed:
            results.append(outcome.result)
        if task.inserted:
            break
    return tuple(results)
