"""A seventh skill: put the jar back on its cradle and let go.

With it the other hand can grasp the jar anew, which corrects a wrong grasp without a
handover in the air. This script tries it on fresh presentations: grasp with the hand on
the wrong side, put back, grasp with the other hand, insert.

    python examples/seventh_skill.py --presentations 40

docs/own_skill.md tells how the skill is made.
"""

import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

import mink
import numpy as np
from tqdm import tqdm

from prospect_mj.actions import plan, poses
from prospect_mj.actions.action import ActionResult
from prospect_mj.actions.plan import Plan, Robot, Step
from prospect_mj.checks import check_integer
from prospect_mj.cli import command_line
from prospect_mj.control.fine_motion import FineMotion
from prospect_mj.control.result import ControlResult, Status
from prospect_mj.recording.config import LARGEST_SEED
from prospect_mj.robot import names
from prospect_mj.robot.names import SIDES, Side
from prospect_mj.skills import SkillRun, Workbench

ABOVE = 0.06
"""Height over its cradle at which the jar arrives, before it goes straight down [m]."""
FALL = 0.003
"""What it falls when the hand opens [m]; a jar pressed on the cradle would slip."""


def put_back(robot: Robot, side: Side) -> Plan:
    """Lay a held jar where it was seen at first, let go and come home."""
    if side not in robot.belief.held or robot.belief.cradle is None:
        return ActionResult.NOT_ALLOWED
    lowered = yield from _lower(robot, side)
    if not lowered.converged:
        return (yield from _abandon(robot, side, lowered))
    # From here on the robot believes what it did when it had looked.
    del robot.belief.held[side]
    robot.belief.seen = robot.belief.cradle
    hand = robot.arms[side].grasp_pose()
    away = poses.backed_off(hand, robot.workspace.stand_off)
    yield from plan.withdraw(robot, side, away)
    return ActionResult.SUCCESS


def _lower(robot: Robot, side: Side) -> Step:
    """Bring the jar over its cradle by a large movement, then down by a fine one."""
    arm, cradle = robot.arms[side], robot.belief.cradle
    posture, outward = plan.arm_posture(arm), names.sign(side) * cradle.axis

    def hand_with_jar(height: float) -> mink.SE3:
        held, place = robot.belief.held[side], cradle.position + [0, 0, height]
        return poses.jar_over(side, arm.grasp_pose(), held, place, outward)

    over = robot.reach(side, hand_with_jar(ABOVE), posture, carrying=True)
    reached = yield from plan.run(over)
    if not reached.converged:
        return reached
    down = FineMotion(arm, hand_with_jar(FALL), posture, carrying=True)
    return (yield from plan.run(down))


def _abandon(robot: Robot, side: Side, result: ControlResult) -> Plan:
    """Back to where a held jar is kept, if it is still held."""
    if result.status is not Status.LOST:
        result = yield from plan.present(robot, side)
    if result.status is Status.LOST:
        yield from plan.drop(robot, side)
        return ActionResult.LOST
    return ActionResult.NOT_REACHED


@dataclass(frozen=True)
class Options:
    """Try the skill on fresh presentations."""

    presentations: int = 40
    """How many, the lid to the left and to the right in turn."""
    seed: int = 0
    """Of the first one; the others follow."""

    def __post_init__(self) -> None:
        """Refuse what can't be tried."""
        check_integer("--presentations", self.presentations, 1, 10_000)
        check_integer("--seed", self.seed, 0, LARGEST_SEED - self.presentations)


@dataclass(frozen=True)
class Try:
    """What came of one presentation."""

    put: SkillRun
    moved: float
    """Where the jar lies now from where it lay at first [m]."""
    inserted: bool
    """Whether the other hand then inserted it."""


def tries(options: Options) -> Iterator[Try]:
    """Grasp wrongly, put back, grasp rightly, insert."""
    with Workbench() as bench:
        for number in range(options.presentations):
            lid = SIDES[number % 2]
            bench.reset(lid, options.seed + number)
            before = bench.task.simulation.jar_position
            bench.run(f"grasp-{names.other(lid)}")
            put = bench.run(put_back, names.other(lid))
            moved = np.linalg.norm(bench.task.simulation.jar_position - before)
            bench.run(f"grasp-{lid}")
            bench.run(f"insert-{lid}")
            yield Try(put, float(moved), bench.inserted)


def report(options: Options) -> None:
    """Try, and print what came of it."""
    done = list(tqdm(tries(options), total=options.presentations, disable=None))
    results = Counter(str(one.put.result) for one in done)
    print("put back:", ", ".join(f"{name} {n}" for name, n in results.items()))
    put = [one for one in done if one.put.succeeded]
    if put:
        seconds = np.mean([one.put.sim_seconds for one in put])
        moved = 1e3 * np.array([one.moved for one in put])
        print(f"simulated time: {seconds:.1f} s")
        print(
            f"the jar has moved by {np.median(moved):.1f} mm, at most {moved.max():.1f}"
        )
    print(f"inserted afterwards: {sum(one.inserted for one in done)} of {len(done)}")


if __name__ == "__main__":
    sys.exit(command_line.main(report, Options(), "seventh_skill.py"))
