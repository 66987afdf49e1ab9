"""The learners' parameters; the class of the settings tells which learner it is.

All of them have epsilon, discount and the number of actions in common. The other sizes
are those of what is observed: `agent.haptics` tells them.
"""

from dataclasses import dataclass
from typing import Literal

from prospect_mj.agent.haptics import N_HOLDINGS
from prospect_mj.checks import check_choice, check_integer, check_number
from prospect_mj.errors import InvalidValue

FORCED_GROUPS = ("insert", "grasp", "others")
"""Kinds of contexts, by their action, that `DiscoverySettings.forced_splits` names."""

_MOST = 1_000_000


@dataclass(frozen=True)
class LinearSettings:
    """Parameters of the linear learner; the defaults are the paper's (section 3.2)."""

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
    name: Literal["linear"] = "linear"
    """Of the learner."""

    def __post_init__(self) -> None:
        """Refuse numbers outside of their range."""
        _check_step_and_start(self)
        _check_common(self, "linear")
        check_integer("number of features", self.n_features, 1, _MOST)


@dataclass(frozen=True)
class ReplaySettings:
    """Parameters of the linear learner that goes through its experience again."""

    step_size: float = 0.02
    """alpha [1]; learning is stable while alpha |phi|^2 < 2."""
    replays: int = 10
    """Transitions learned from again after every action."""
    buffer: int = 1000
    """Transitions remembered: the latest."""
    replays_forget: bool = False
    """Whether the target of what is replayed counts all actions, as if it weren't known
    any more what could be chosen: a control for the rule for failed actions."""
    epsilon: float = 0.05
    """Probability of choosing an action at random [1]."""
    discount: float = 0.99
    """gamma [1], per action."""
    initial_sd: float = 0.02
    """Standard deviation of the normal distribution, of mean zero, that initial weights
    are drawn from [actions]."""
    n_actions: int = 6
    """Number of actions."""
    n_features: int = 303
    """Length of a feature vector."""
    name: Literal["replay"] = "replay"
    """Of the learner."""

    def __post_init__(self) -> None:
        """Refuse numbers outside of their range."""
        _check_step_and_start(self)
        _check_common(self, "replay")
        _check_experience(self)
        check_integer("number of features", self.n_features, 1, _MOST)


@dataclass(frozen=True)
class TableSettings:
    """Parameters of the table, which is told the orientation."""

    step_size: float = 0.1
    """alpha [1]."""
    replays: int = 0
    """Transitions learned from again after every action."""
    buffer: int = 1000
    """Transitions remembered: the latest; without replays none are."""
    replays_forget: bool = False
    """Whether the target of what is replayed counts all actions, as if it weren't known
    any more what could be chosen: a control for the rule for failed actions."""
    copied_habit: bool = False
    """Whether an orientation that was never learned from has a copy of the other one's
    values: what is done with the one is done with the other, as in infants."""
    known_correction: bool = False
    """Whether in that copy the swap towards the lid's hand, and the insertion after it,
    have their right values."""
    epsilon: float = 0.05
    """Probability of choosing an action at random [1]."""
    discount: float = 0.99
    """gamma [1], per action."""
    initial_sd: float = 0.02
    """Standard deviation of the normal distribution, of mean zero, that initial values
    are drawn from [actions]."""
    n_actions: int = 6
    """Number of actions."""
    n_haptic: int = N_HOLDINGS
    """Number of haptic states."""
    name: Literal["table"] = "table"
    """Of the learner."""

    def __post_init__(self) -> None:
        """Refuse numbers outside of their range."""
        _check_step_and_start(self)
        _check_common(self, "table")
        _check_experience(self)
        check_integer("number of haptic states", self.n_haptic, 1, _MOST)
        check_choice("copied_habit", self.copied_habit, (False, True))
        check_choice("known_correction", self.known_correction, (False, True))
        if self.known_correction and not self.copied_habit:
            expected = "false without copied_habit, to whose copy it belongs"
            raise InvalidValue("known_correction", self.known_correction, expected)


@dataclass(frozen=True)
class DiscoverySettings:
    """Parameters of the learner that discovers features as it needs them."""

    least_rate: float = 0.005
    """Least rate at which a value follows its targets [1]: the inertia of habits."""
    surprise: float = 0.5
    """How far a target is from what was expected for an example to count [actions]."""
    guard_probability: float = 1e-5
    """With which two samples of one distribution seem to be different [1]."""
    candidates: int = 30
    """New features that are drawn in one search."""
    memory: int = 40
    """Examples remembered of each class in each context: the latest."""
    features_per_context: int = 3
    """At most."""
    reuse: bool = True
    """Whether features found in other contexts are tried before new ones are drawn."""
    search_after_first: bool = True
    """Whether a context that has a feature searches for others."""
    expert_phase: bool = False
    """Whether it is searched for better features where nothing is wrong."""
    revalue: Literal["examples", "stored", "inherit"] = "examples"
    """Where the values come from when a context splits: from remembered examples, by
    what is known at present of what follows; from the same by their targets as they
    were at the time; from the value before."""
    labels: Literal["td", "return"] = "td"
    """What says whether an example was better or worse than expected: its target, or
    all that the rest of its trial brought."""
    cache: Literal["surprising", "all"] = "surprising"
    """Which examples are remembered: those far from their context's mean, or all."""
    share_first: bool = False
    """Whether the first feature is given to all contexts at once, without any change
    of their values."""
    forced_splits: tuple[tuple[str, int], ...] = ()
    """Contexts to be split by the true orientation, and the number, from 0, of the
    trial after which they are: ("insert" | "grasp" | "others", trial), where "others"
    are those of no other entry. With any, nothing else is discovered."""
    epsilon: float = 0.05
    """Probability of choosing an action at random [1]."""
    discount: float = 0.99
    """gamma [1], per action."""
    n_actions: int = 6
    """Number of actions."""
    n_haptic: int = N_HOLDINGS
    """Number of haptic states."""
    name: Literal["discovery"] = "discovery"
    """Of the learner."""

    def __post_init__(self) -> None:
        """Refuse numbers and choices outside of their range."""
        check_number("least_rate", self.least_rate, 0, 1)
        check_number("surprise", self.surprise, 0, 1000)
        guard = self.guard_probability
        check_number("guard_probability", guard, 0, 1, above=True)
        check_integer("candidates", self.candidates, 0, _MOST)
        check_integer("memory", self.memory, 2, _MOST)
        check_integer("features_per_context", self.features_per_context, 1, 100)
        for name in ("reuse", "search_after_first", "expert_phase", "share_first"):
            check_choice(name, getattr(self, name), (False, True))
        check_choice("revalue", self.revalue, ("examples", "stored", "inherit"))
        check_choice("labels", self.labels, ("td", "return"))
        check_choice("cache", self.cache, ("surprising", "all"))
        _check_forced(self)
        _check_common(self, "discovery")
        check_integer("number of haptic states", self.n_haptic, 1, _MOST)


AnyLearnerSettings = LinearSettings | ReplaySettings | TableSettings | DiscoverySettings
"""Of one of the learners."""


def _check_common(settings: AnyLearnerSettings, name: str) -> None:
    check_number("epsilon", settings.epsilon, 0, 1)
    check_number("discount", settings.discount, 0, 1)
    check_integer("number of actions", settings.n_actions, 1, _MOST)
    check_choice("name of the learner", settings.name, (name,))


def _check_step_and_start(
    settings: LinearSettings | ReplaySettings | TableSettings,
) -> None:
    check_number("step_size", settings.step_size, 0, 10, above=True)
    check_number("initial_sd", settings.initial_sd, 0, 1000)


def _check_experience(settings: ReplaySettings | TableSettings) -> None:
    check_integer("replays", settings.replays, 0, 1000)
    check_integer("buffer", settings.buffer, 1, _MOST)
    check_choice("replays_forget", settings.replays_forget, (False, True))
    if settings.replays_forget and not settings.replays:
        expected = "false without replays"
        raise InvalidValue("replays_forget", settings.replays_forget, expected)


def _check_forced(settings: DiscoverySettings) -> None:
    splits = settings.forced_splits
    groups = [group for group, _ in splits]
    for group, trial in splits:
        check_choice("contexts of a forced split", group, FORCED_GROUPS)
        check_integer("trial of a forced split", trial, 0, _MOST)
    if len(set(groups)) < len(groups):
        raise InvalidValue("forced splits", splits, "one of each kind of contexts")
    for name in ("share_first", "expert_phase"):
        if splits and getattr(settings, name):
            expected = "false with forced_splits, as nothing is discovered then"
            raise InvalidValue(name, True, expected)
