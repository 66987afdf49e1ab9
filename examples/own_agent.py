"""An agent of one's own: a table over six states.

It knows two pictures, the brighter and the darker than what it has seen on average, and
three states of the hands.
"""

import sys
from dataclasses import dataclass

import gymnasium
import numpy as np
from comparison import check, report

import prospect_mj  # noqa: F401  (registers the environment)
from prospect_mj.cli import command_line

STEP_SIZE, EPSILON = 0.2, 0.1


@dataclass(frozen=True)
class Options:
    """Train a tabular Q-learner on recorded physics."""

    trials: int = 1000
    """How many."""
    seed: int = 0
    """Of presentations and exploration."""

    def __post_init__(self) -> None:
        """Refuse numbers that can't be."""
        check(self)


class OwnAgent:
    """Q-learning on a table."""

    def __init__(self, rng: np.random.Generator) -> None:
        """Know nothing."""
        self.values, self.rng = np.zeros((6, 6)), rng
        self.mean, self.seen = 0.0, 0

    def look(self, features: np.ndarray) -> None:
        """Take the picture of a new trial into the mean."""
        self.seen += 1
        self.mean += (_brightness(features) - self.mean) / self.seen

    def state(self, features: np.ndarray) -> int:
        """Number of the state: the picture's kind, and the hand that holds the jar."""
        hand = int(features[300] + 2 * features[301])
        return 3 * int(_brightness(features) > self.mean) + hand

    def act(self, state: int) -> int:
        """Choose, at random once in a while."""
        values = self.values[state] + 1e-9 * self.rng.random(6)
        explore = self.rng.random() < EPSILON
        return int(self.rng.integers(6) if explore else values.argmax())

    def learn(self, state: int, action: int, target: float) -> None:
        """Move a value towards what was found."""
        self.values[state, action] += STEP_SIZE * (target - self.values[state, action])


def _brightness(features: np.ndarray) -> float:
    """Mean grey level of the jar, as a number of bins."""
    histogram = features[:100]
    return float(histogram @ np.arange(100) / histogram.sum())


def train(options: Options) -> list[int]:
    """Let the agent learn; actions of each trial."""
    env = gymnasium.make("prospect_mj/PickPlace-v0", physics="recorded")
    agent, lengths = OwnAgent(np.random.default_rng(options.seed)), []
    for trial in range(options.trials):
        features, _ = env.reset(seed=options.seed if trial == 0 else None)
        agent.look(features)
        ended, n_actions = False, 0
        while not ended:
            state = agent.state(features)
            action = agent.act(state)
            features, reward, terminated, truncated, _ = env.step(action)
            future = 0.0 if terminated else agent.values[agent.state(features)].max()
            agent.learn(state, action, reward + future)
            ended, n_actions = terminated or truncated, n_actions + 1
        lengths.append(n_actions)
    return lengths


def main(options: Options) -> None:
    """Train, and print what came of it."""
    print(report("own agent", train(options), options.seed))


if __name__ == "__main__":
    sys.exit(command_line.main(main, Options(), "own_agent.py"))
