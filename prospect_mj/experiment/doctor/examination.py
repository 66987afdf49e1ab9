"""All that the doctor looks at, in order."""

from collections import Counter
from collections.abc import Iterator, Sequence

from prospect_mj.experiment.doctor import machine, packages, recorded, rendering
from prospect_mj.experiment.doctor.check import Check, Level, Look, guarded

LOOKS: dict[str, Look] = {
    "Python": packages.look_at_python,
    "packages": packages.look_at_packages,
    "cores": machine.look_at_cores,
    "memory": machine.look_at_memory,
    "places": machine.look_at_places,
    "recorded physics": recorded.look_at_recordings,
    "rendering": rendering.look_at_rendering,
    "display": rendering.look_at_display,
}
"""By what they look at."""


def examine() -> Iterator[tuple[str, Iterator[Check]]]:
    """Each look: what at, and what it finds once it is asked for."""
    for name, look in LOOKS.items():
        yield name, guarded(name, look)


def verdict(checks: Sequence[Check]) -> str:
    """One line for all of them."""
    counted = Counter(one.level for one in checks)
    if counted[Level.OK] == len(checks):
        return "all is well"
    return ", ".join(f"{counted[level]} {level}" for level in Level)
