"""What can be run as a skill: one of the six actions, or a plan of one's own."""

import inspect
from collections.abc import Callable, Generator
from typing import TypeAlias

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.actions.plan import Plan, Robot
from prospect_mj.control.controller import Controller
from prospect_mj.errors import InvalidChoice, InvalidValue
from prospect_mj.robot.names import Side, checked_side

Writer: TypeAlias = Callable[[Robot], Plan] | Callable[[Robot, Side], Plan]
"""Writes a plan over the robot, or over the robot and the side of a hand."""

Skill: TypeAlias = Action | str | Writer
"""An action, its label such as `grasp-left`, or a function that writes a plan."""

_ACTIONS = {action.label: action for action in Action}


def action_of(skill: Skill) -> Action | None:
    """The action that is meant; None: a plan of one's own.

    Raises:
        InvalidChoice: if there is no action of that name.
    """
    if isinstance(skill, Action):
        return skill
    if callable(skill):
        return None
    if not isinstance(skill, str) or skill not in _ACTIONS:
        raise InvalidChoice("skill", skill, [*_ACTIONS, "a function of the robot"])
    return _ACTIONS[skill]


def name_of(writer: Writer, side: Side | None) -> str:
    """What a plan of one's own is called: `put_back` and `left` are `put-back-left`."""
    name = getattr(writer, "__name__", type(writer).__name__).replace("_", "-")
    return name if side is None else f"{name}-{side}"


def plan_of(writer: Writer, robot: Robot, side: Side | None) -> Plan:
    """Write a plan.

    Args:
        writer: the function that does.
        robot: what it is written over.
        side: the hand, for a function that takes one.

    Raises:
        InvalidChoice: if there is no such side.
        InvalidValue: if the function takes a side and gets none, or takes none and gets
            one, or if it does not write a plan.
    """
    given = (robot,) if side is None else (robot, checked_side(side))
    try:
        inspect.signature(writer).bind(*given)
    except (TypeError, ValueError) as error:
        name = name_of(writer, None)
        raise InvalidValue("side", side, f"what {name} takes: {error}") from None
    plan = writer(*given)
    if not isinstance(plan, Generator):
        raise InvalidValue("skill", plan, "a generator that yields controllers")
    return _checked(plan)


def _checked(plan: Plan) -> Plan:
    """The same plan; it is told of what no plan may yield or return.

    Raises:
        InvalidValue: while it runs, if it does so.
    """
    while True:
        try:
            together = next(plan)
        except StopIteration as end:
            if not isinstance(end.value, ActionResult):
                expected = "an ActionResult, which a plan returns"
                raise InvalidValue("result", end.value, expected) from None
            return end.value
        controllers = together if isinstance(together, tuple) else (None,)
        if not all(isinstance(one, Controller) for one in controllers):
            raise InvalidValue("yielded", together, "a tuple of controllers")
        yield together
