"""The worlds that can be recorded and lived in: what is unlike the paper's, by name.

What a world is decides its outcomes, so a recording's key has the digest of it.
"""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from types import MappingProxyType

from prospect_mj.sim.props import Jar, Lamp, Post, Props, Recess, Well


@dataclass(frozen=True)
class World:
    """What stands round the torso, and how well its eyes see."""

    about: str
    """In words, for lists and tables."""
    props: Props = field(default_factory=Props)
    """Jar, receptacle, lamp and the rest."""
    noise_sd: float = 2.0
    """Of the eyes, each channel of each pixel [grey levels]."""

    @property
    def lid_first(self) -> bool:
        """Whether the lid's end goes down, in place of the body's."""
        return self.props.well.post is not None

    @property
    def digest(self) -> str:
        """SHA-256 of all that decides an outcome, as hexadecimal digits."""
        parts = asdict(self.props), self.noise_sd
        return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


STANDARD = "standard"

WORLDS: Mapping[str, World] = MappingProxyType(
    {
        STANDARD: World("the paper's: only the body end fits the receptacle"),
        "post": World(
            "a post in the receptacle, which only a recess in the lid goes over",
            Props(
                jar=Jar(recess=Recess()),
                well=Well(half_width=0.049, depth=0.035, post=Post()),
            ),
        ),
        "lamp-right": World(
            "the lamp on the right in place of the left",
            Props(lamp=Lamp(position=(0.50, -0.80, 1.20), stand=(1.00, -0.66))),
        ),
        "lamp-high": World(
            "the lamp higher up and nearer the middle: both pictures are more alike",
            Props(lamp=Lamp(position=(0.55, 0.25, 1.50), stand=(1.00, 0.66))),
        ),
        "noisy": World("eyes with five times the noise", noise_sd=10.0),
        "ring-label": World(
            "a jar with a narrow ring for a label", Props(jar=Jar(label=(-0.020, 0.0)))
        ),
        "wide-lid": World(
            "a lid of 48 mm radius in place of 45", Props(jar=Jar(lid_radius=0.048))
        ),
        "narrow-lid": World(
            "a lid of 42 mm radius in place of 45", Props(jar=Jar(lid_radius=0.042))
        ),
    }
)
"""By name."""
