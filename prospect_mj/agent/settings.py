"""The learner's parameters."""

from dataclasses import dataclass

from prospect_mj.errors import InvalidValue


@dataclass(frozen=True)
class LearnerSettings:
    """Parameters of the learner; the defaults are the paper's (section 3.2)."""

    step_size: float = 0.004
    """alpha [1]; learning is stable while alpha |phi|^2 < 2."""
    epsilon: float = 0.05
    """Probability of choosing an action at random [1]."""
    discount: float = 0.99
    """gamma [1], per action."""
    n_actions: int = 6
    """Number of actions."""
    n_features: int = 303
    """Length of a feature vector."""

    def __post_init__(self) -> None:
        """Refuse numbers outside of their range."""
        if not 0 < self.step_size <= 10:
            raise InvalidValue("step size", self.step_size, "a number in (0, 10]")
        if not 0 <= self.epsilon <= 1:
            raise InvalidValue("epsilon", self.epsilon, "a number in [0, 1]")
        if not 0 <= self.discount <= 1:
            raise InvalidValue("discount", self.discount, "a number in [0, 1]")
        if self.n_actions < 1:
            raise InvalidValue("number of actions", self.n_actions, "at least 1")
        if self.n_features < 1:
            raise InvalidValue("number of features", self.n_features, "at least 1")
