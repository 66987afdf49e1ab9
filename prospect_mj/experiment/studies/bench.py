"""The benchmark: simulated seconds per wall second, and where the wall time goes."""

from collections import defaultdict
from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass
from functools import wraps
from time import perf_counter
from typing import TYPE_CHECKING, ParamSpec, TypeVar, cast

from prospect_mj.checks import check_integer
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import make_environment
from prospect_mj.experiment.run.training import new_learner, run_trial
from prospect_mj.recording.config import LARGEST_SEED, GrossMotion

if TYPE_CHECKING:
    from prospect_mj.envs.pick_place import PickPlaceEnv

PHYSICS, IK, RENDERING, VISION = "mj_step", "inverse kinematics", "rendering", "vision"
PLANNING = "planning"
OTHER = "other control, learner, reset"

Tick = Callable[[], object]

_Arguments = ParamSpec("_Arguments")
_Result = TypeVar("_Result")


@dataclass(frozen=True)
class BenchConfig:
    """What to measure."""

    trials: int = 20
    """Whole trials of an untrained learner, vision and learning included."""
    seed: int = 0
    """Of the presentations and of the learner."""
    gross_motion: GrossMotion = "harmonic"
    """How large movements go."""

    def __post_init__(self) -> None:
        """Refuse a benchmark of nothing."""
        check_integer("trials", self.trials, 1, 100_000)
        check_integer("seed", self.seed, 0, LARGEST_SEED)


@dataclass(frozen=True)
class BenchResult:
    """What was measured."""

    simulated: float
    """Simulated time of all actions [s]."""
    wall: float
    """[s]"""
    shares: dict[str, float]
    """Share of the wall time by what it was spent on; they add up to 1."""
    look: float
    """Wall time of one look, image pair to histogram and pose [s]."""

    def report(self) -> str:
        """A few lines for people."""
        ratio = self.simulated / self.wall
        lines = [f"{ratio:.1f} simulated seconds per wall second"]
        lines += [f"  {label:30s}{share:6.1%}" for label, share in self.shares.items()]
        look = f"one look: {1e3 * self.look:.0f} ms, rendering included"
        return "\n".join([*lines, look])

    def figures(self) -> dict[str, object]:
        """The same for programs."""
        return {
            "simulated_seconds": self.simulated,
            "wall_seconds": self.wall,
            "times_real_time": self.simulated / self.wall,
            "shares_of_wall_time": self.shares,
            "look_seconds": self.look,
        }


class Stopwatch:
    """Adds up the wall time of functions, by label."""

    def __init__(self) -> None:
        """Start with no time spent."""
        self.seconds: dict[str, float] = defaultdict(float)

    def timed(
        self, label: str, function: Callable[_Arguments, _Result]
    ) -> Callable[_Arguments, _Result]:
        """`function`, with its time added to `label`."""

        @wraps(function)
        def wrapped(*args: _Arguments.args, **kwargs: _Arguments.kwargs) -> _Result:
            start = perf_counter()
            try:
                return function(*args, **kwargs)
            finally:
                self.seconds[label] += perf_counter() - start

        return wrapped


def bench(config: BenchConfig, tick: Tick = lambda: None) -> BenchResult:
    """Run whole trials on live physics and measure.

    Args:
        config: what to measure.
        tick: called after each trial.

    Raises:
        ProspectError: if a model file is missing or nothing can be rendered.
    """
    training = TrainConfig(
        trials=config.trials, seed=config.seed, gross_motion=config.gross_motion
    )
    with closing(cast("PickPlaceEnv", make_environment(training))) as env:
        # Warms up: compiled code is loaded, or made, when it is first called.
        run_trial(training, env, new_learner(training), config.trials)
        watch = _instrumented(env)
        learner = new_learner(training)
        simulated, start = 0.0, perf_counter()
        for trial in range(config.trials):
            simulated += run_trial(training, env, learner, trial).trial.sim_seconds
            tick()
        wall = perf_counter() - start
    return _result(simulated, wall, watch, config.trials)


def _instrumented(env: "PickPlaceEnv") -> Stopwatch:
    """Put a stopwatch round the calls that the time goes to."""
    watch = Stopwatch()
    task = env.task
    parts = [(task.simulation, "step", PHYSICS), (task.camera, "capture", RENDERING)]
    parts += [(task.vision, "look", VISION)]
    for arm in task.runner.arms.values():
        parts += [(arm.ik, "solve", IK), (arm.ik, "solve_posture", IK)]
        if arm.planner is not None:
            parts += [(arm.planner, name, PLANNING) for name in ("plan", "resume")]
    for owner, name, label in parts:
        setattr(owner, name, watch.timed(label, getattr(owner, name)))
    return watch


def _result(
    simulated: float, wall: float, watch: Stopwatch, trials: int
) -> BenchResult:
    labels = (PHYSICS, IK, PLANNING, RENDERING, VISION)
    shares = {label: watch.seconds[label] / wall for label in labels}
    shares[OTHER] = 1.0 - sum(shares.values())
    look = (watch.seconds[RENDERING] + watch.seconds[VISION]) / trials
    return BenchResult(simulated, wall, shares, look)
