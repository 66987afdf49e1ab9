"""The learner's numbers of the actions against the task's."""

from prospect_mj.actions.action import Action
from prospect_mj.agent.action_numbers import GRASPS, INSERTS, SWAPS_TO


def test_actions_are_those_of_the_task():
    assert GRASPS == (Action.GRASP_LEFT, Action.GRASP_RIGHT)
    assert SWAPS_TO == (Action.SWAP_RIGHT_TO_LEFT, Action.SWAP_LEFT_TO_RIGHT)
    assert INSERTS == (Action.INSERT_LEFT, Action.INSERT_RIGHT)
