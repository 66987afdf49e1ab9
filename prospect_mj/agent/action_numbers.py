"""Numbers of the actions, by the left and the right hand.

They are those of `prospect_mj.actions.Action`, which knows of the robot, as a learner
must not.
"""

GRASPS = (0, 1)
"""The action by which a hand picks the jar up."""
SWAPS_TO = (3, 2)
"""The action that hands the jar to a hand."""
INSERTS = (4, 5)
"""The action that inserts what a hand holds."""
