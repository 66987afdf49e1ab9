"""The learner that discovers features as it needs them."""

from prospect_mj.agent.discovery.discovery_q import DiscoveryQ

__all__ = ["DiscoveryQ"]
