"""Size of the comparison with rivals."""

from dataclasses import dataclass

from prospect_mj.checks import check_choice, check_integer, check_number
from prospect_mj.errors import InvalidValue
from prospect_mj.recording.config import LARGEST_SEED

LINEAR, LINEAR_MASKED = "linear", "linear-masked"
DQN_ANNEALED, DQN_CONSTANT = "dqn-annealed", "dqn-constant"
MASKABLE_PPO = "maskable-ppo"
DEEP = (DQN_ANNEALED, DQN_CONSTANT, MASKABLE_PPO)
AGENTS = (LINEAR, LINEAR_MASKED, *DEEP)
MASKED = (LINEAR_MASKED, MASKABLE_PPO)
"""Those that choose from the supervisor's mode `productive`, all others from all."""

_MOST_TRIALS = 100_000
_MOST_RUNS = 1000
_MOST_ERROR = 30.0


@dataclass(frozen=True)
class RivalSettings:
    """What is compared, and how often."""

    agents: tuple[str, ...] = AGENTS
    """The learners."""
    linear_runs: int = 1000
    """Runs of each linear learner."""
    deep_runs: int = 10
    """Runs of each deep learner, and of the groups that the linear ones are measured
    in."""
    deep_trials: int = 1500
    """Trials of a run, of whatever learner; both orientations from the first on."""
    seed: int = 0
    """Of learners and presentations."""
    size_errors: tuple[int, ...] = (-6, -5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6)
    """By how much the planner takes receptacle and lid for wider than they are [mm]."""
    flips: tuple[float, ...] = (0.0, 0.02, 0.05, 0.1, 0.2, 0.5)
    """Probability with which the planner takes the lid to be on the other side [1]."""
    live_presentations: int = 2
    """Presentations of each orientation in which live physics is searched; 0: none."""
    live_errors: tuple[int, ...] = (-5, -4, 4, 5)
    """By how much the receptacle of the searched physics is wider than that of the
    world [mm], with one presentation of each orientation."""
    depth: int = 4
    """Longest sequence that a search tries [actions]."""

    def __post_init__(self) -> None:
        """Refuse what can't be compared."""
        for agent in self.agents:
            check_choice("learner", agent, AGENTS)
        if len(set(self.agents)) != len(self.agents):
            raise InvalidValue("learners", self.agents, "each of them once")
        check_integer("linear runs", self.linear_runs, 2, 100 * _MOST_RUNS)
        check_integer("deep runs", self.deep_runs, 2, _MOST_RUNS)
        check_integer("deep trials", self.deep_trials, 50, _MOST_TRIALS)
        check_integer("seed", self.seed, 0, LARGEST_SEED)
        for error in (*self.size_errors, *self.live_errors):
            check_number("error of a size", error, -_MOST_ERROR, _MOST_ERROR)
        for flip in self.flips:
            check_number("probability of a flip", flip, 0, 1)
        check_integer("live presentations", self.live_presentations, 0, 50)
        check_integer("depth", self.depth, 1, 6)

    @property
    def deep(self) -> tuple[str, ...]:
        """The deep learners among the agents."""
        return tuple(agent for agent in self.agents if agent in DEEP)

    @property
    def linear(self) -> tuple[str, ...]:
        """The others."""
        return tuple(agent for agent in self.agents if agent not in DEEP)
