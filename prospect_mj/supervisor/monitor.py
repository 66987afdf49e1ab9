"""The monitor: holds what the robot observes of itself against the model.

A guarantee of the supervisor is worth what its model is worth. An event that the
automaton does not foresee is a failure of the model: it is raised and not passed over,
since from there on nothing is known to be safe.
"""

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.errors import InvalidValue, UnforeseenEvent
from prospect_mj.supervisor.plant import INITIAL, End, Situation, Start, supervision
from prospect_mj.supervisor.predicates import PredicateState


class Monitor:
    """Follows a trial through the supervised automaton.

    Attributes:
        situation: where the automaton stands.
        word: the events since the trial began or was resumed.
    """

    def __init__(self) -> None:
        """Stand where a trial begins: the look is under way."""
        self.situation = INITIAL
        self.word: list[Start | End] = []

    @property
    def predicates(self) -> PredicateState:
        """As they were last observed."""
        return self.situation.predicates

    def begin(self, observed: PredicateState) -> None:
        """A trial has begun and the look has ended.

        Raises:
            UnforeseenEvent: if no trial can begin so.
        """
        self.situation, self.word = INITIAL, []
        found = observed.jar == "seen"
        self._accept(
            End(ActionResult.SUCCESS if found else ActionResult.NOT_SEEN, observed)
        )

    def resume(self, predicates: PredicateState) -> None:
        """Go on between two actions of a trial that was followed before.

        Raises:
            InvalidValue: if no trial gets there.
        """
        if Situation(predicates) not in supervision().kept:
            expected = "a state that supervision allows"
            raise InvalidValue("predicates", str(predicates), expected)
        self.situation, self.word = Situation(predicates), []

    def follow(
        self, action: Action, result: ActionResult, observed: PredicateState
    ) -> None:
        """An action was started and has ended, or it was refused.

        Raises:
            UnforeseenEvent: if it can't have been started, or can't end so.
        """
        if result is not ActionResult.NOT_ALLOWED:
            self._accept(Start(action))
            self._accept(End(result, observed))
        elif observed != self.predicates:
            # Refused: there was no event, and nothing may have moved.
            raise UnforeseenEvent(str(End(result, observed)), str(self.predicates))

    def _accept(self, event: Start | End) -> None:
        run = supervision().automaton.run((event,), self.situation)
        if run.refused is not None:
            during = self.situation.running
            when = "" if during is None else f"{getattr(during, 'label', during)} from "
            raise UnforeseenEvent(str(event), f"{when}{self.predicates}")
        self.situation = run.state
        self.word.append(event)
