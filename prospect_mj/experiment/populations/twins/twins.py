"""Which learner is run by which compiled code."""

from prospect_mj.agent import (
    AnyLearnerSettings,
    DiscoverySettings,
    LinearSettings,
    ReplaySettings,
    TableSettings,
)
from prospect_mj.experiment.populations.twins import (
    discovery_twin,
    linear_twin,
    replay_twin,
    table_twin,
)
from prospect_mj.experiment.populations.twins.twin import Twin

TWINS: dict[type[AnyLearnerSettings], Twin] = {
    LinearSettings: linear_twin.TWIN,
    ReplaySettings: replay_twin.TWIN,
    TableSettings: table_twin.TWIN,
    DiscoverySettings: discovery_twin.TWIN,
}
"""By the class of a learner's settings."""
