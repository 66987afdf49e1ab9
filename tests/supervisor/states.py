"""Predicate states in few letters, for tables by hand."""

from prospect_mj.supervisor.predicates import ArmState, Jar, Place, PredicateState

_ARMS = {
    "r": ArmState(False, Place.REST),
    "f": ArmState(False, Place.FRONT),
    "a": ArmState(False, Place.ASTRAY),
    "R": ArmState(True, Place.REST),
    "F": ArmState(True, Place.FRONT),
    "A": ArmState(True, Place.ASTRAY),
}
_JARS = {"s": Jar.SEEN, "i": Jar.INSERTED, "-": Jar.UNKNOWN}


def state(letters):
    """Left arm, right arm (rest, front, astray; capital = holds), jar: such as Fr-."""
    left, right, jar = letters
    return PredicateState(_ARMS[left], _ARMS[right], _JARS[jar])


def mirrored(predicates):
    return PredicateState(predicates.right, predicates.left, predicates.jar)
