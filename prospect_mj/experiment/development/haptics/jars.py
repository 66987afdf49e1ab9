"""The jars that are grasped live."""

from collections.abc import Mapping
from types import MappingProxyType

from prospect_mj.sim.props import Jar, Props

STANDARD = "standard"
JARS: Mapping[str, Props] = MappingProxyType(
    {
        STANDARD: Props(),
        "wide-lid": Props(jar=Jar(lid_radius=0.048)),
        "narrow-lid": Props(jar=Jar(lid_radius=0.042)),
    }
)
"""By name: lids of 45, 48 and 42 mm radius on a body of 36 mm. One of 38 mm the eyes
take for no lid."""
