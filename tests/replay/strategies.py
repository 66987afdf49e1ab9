"""What the learner may do in a trial whose jar has its lid to the left."""

import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.replay.rerun_export import Decision, Story

STRATEGIES = {
    "optimal": (Action.GRASP_LEFT, Action.INSERT_LEFT),
    "early": (Action.GRASP_RIGHT, Action.SWAP_RIGHT_TO_LEFT, Action.INSERT_LEFT),
    "late": (
        Action.GRASP_RIGHT,
        Action.INSERT_RIGHT,
        Action.SWAP_RIGHT_TO_LEFT,
        Action.INSERT_LEFT,
    ),
    "timed_out": (
        *(Action.SWAP_LEFT_TO_RIGHT, Action.GRASP_RIGHT, Action.INSERT_RIGHT),
        *(Action.SWAP_RIGHT_TO_LEFT, Action.SWAP_LEFT_TO_RIGHT) * 3,
        Action.INSERT_RIGHT,
    ),
}


def story_of(name, episode):
    """Estimates of a learner that there never was."""
    rng = np.random.default_rng(0)
    decisions = [
        Decision(rng.uniform(-9, -1, len(Action)), explored=number == 1)
        for number in range(len(episode.actions))
    ]
    return Story(f"a trial: {name}", decisions)
