"""The learner's parameters."""

from dataclasses import dataclass

from prospect_mj.checks import check_integer, check_number

_MOST = 1_000_000


@dataclass(frozen=True)
class LearnerSettings:
    """Parameters of the learner; the defaults are the paper's (section 3.2)."""

    step_size: float = 0.004
    """alpha [1]; learning is stable while alpha |phi|^2 < 2."""
    epsilon: float = 0.05
    """Probability of choosing an action at random [1]."""
    discount: float = 0.99
    """gamma [1], per action."""
    initial_sd: float = 0.02
    """Standard deviation of the normal distribution, of mean zero, that initial weights
    are drawn from [actions]. The paper says "arbitrary initial values"; 0.02 is one of
    several that fit its figures equally well (docs/reproduction.md)."""
    n_actions: int = 6
    """Number of actions."""
    n_features: int = 303
    """Length of a feature vector."""

    def __post_init__(self) -> None:
        """Refuse numbers outside of their range."""
        check_number("step_size", self.step_size, 0, 10, above=True)
        check_number("epsilon", self.epsilon, 0, 1)
        check_number("discount", self.discount, 0, 1)
        check_number("initial_sd", self.initial_sd, 0, 1000)
        check_integer("number of actions", self.n_actions, 1, _MOST)
        check_integer("number of features", self.n_features, 1, _MOST)
