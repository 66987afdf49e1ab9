"""The predicates of a node, as the columns of a recording's tables have them."""

from prospect_mj.supervisor.predicates import ArmState, Jar, Place, PredicateState

COLUMNS = ("left_holds", "left_place", "right_holds", "right_place", "jar")


def words_of(state: PredicateState) -> dict[str, bool | str]:
    """A state of the supervisor as truths and words, by column."""
    left, right, jar = state
    return dict(zip(COLUMNS, (*left, *right, jar), strict=True))


def predicates_of(
    left_holds: bool, left_place: str, right_holds: bool, right_place: str, jar: str
) -> PredicateState:
    """The state that `words_of` has made words of."""
    left = ArmState(left_holds, Place(left_place))
    right = ArmState(right_holds, Place(right_place))
    return PredicateState(left, right, Jar(jar))
