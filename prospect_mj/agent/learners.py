"""Every learner by its name and by the class of its settings."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from prospect_mj.agent.haptics import n_features, n_haptic
from prospect_mj.agent.learner import Learner
from prospect_mj.agent.linear_q import LinearQ
from prospect_mj.agent.replay_q import ReplayQ
from prospect_mj.agent.settings import (
    AnyLearnerSettings,
    DiscoverySettings,
    LinearSettings,
    ReplaySettings,
    TableSettings,
)
from prospect_mj.agent.table_q import TableQ
from prospect_mj.checks import check_choice, check_names

SETTINGS: Mapping[str, type[AnyLearnerSettings]] = {
    kind.name: kind
    for kind in (LinearSettings, ReplaySettings, TableSettings, DiscoverySettings)
}
"""Class of the settings of each learner, by its name."""

NAMES = tuple(SETTINGS)
DEFAULTS: Mapping[str, AnyLearnerSettings] = {
    name: kind() for name, kind in SETTINGS.items()
}
"""Each learner as it is where nothing else is said, by its name."""


def with_categories(
    settings: AnyLearnerSettings, categories: int
) -> AnyLearnerSettings:
    """The same learner for states that tell K = `categories` kinds of grasps."""
    sizes = {"n_features": n_features(categories), "n_haptic": n_haptic(categories)}
    own = {name: size for name, size in sizes.items() if hasattr(settings, name)}
    return replace(settings, **own)


def new_learner(
    settings: AnyLearnerSettings, rng: np.random.Generator | None = None
) -> Learner:
    """The learner of some settings, without experience.

    Args:
        settings: parameters, whose class tells which learner it is.
        rng: draws where it starts from; None: from zero.
    """
    match settings:
        case LinearSettings():
            return LinearQ(settings, rng)
        case ReplaySettings():
            return ReplayQ(settings, rng)
        case TableSettings():
            return TableQ(settings, rng)
        case DiscoverySettings():
            # Only here: the other learners don't need it.
            from prospect_mj.agent.discovery.discovery_q import DiscoveryQ

            return DiscoveryQ(settings, rng)


def settings_of(plain: Mapping[str, Any]) -> AnyLearnerSettings:
    """The settings that `dataclasses.asdict` made plain, by way of JSON or not.

    Raises:
        ProspectError: on an unknown learner, or a setting that is missing, unknown or
            out of range.
    """
    name = plain.get("name")
    check_choice("learner", name, NAMES)
    kind = SETTINGS[name]
    check_names(plain, kind)
    return kind(**{field: _tupled(value) for field, value in plain.items()})


def _tupled(value: object) -> object:
    """A value with tuples where JSON has lists."""
    return tuple(map(_tupled, value)) if isinstance(value, list) else value
