"""What a learner is told of a grasp, and the recorded outcomes with that told.

Which hand holds the jar (the two bits), the category of the grasp as well, or, as a
bound on what any haptic category could do, the very end that is held.
"""

from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.development.haptics.grasp import BODY, LID
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.haptics import TrajectoryModels
from prospect_mj.recording.felt import category_of_nodes
from prospect_mj.recording.recording import Recording

Touch = Literal["two bits", "category", "end"]
TOUCHES: tuple[Touch, ...] = get_args(Touch)
BITS, CATEGORY, END = TOUCHES


def worlds(
    recording: Recording, models: TrajectoryModels
) -> dict[Touch, RecordedWorld]:
    """The same outcomes, by what is told of a grasp."""
    category = category_of_nodes(recording, models)
    return {
        BITS: RecordedWorld(recording),
        CATEGORY: RecordedWorld(recording, len(models), category),
        END: RecordedWorld(recording, len((BODY, LID)), ends_of_nodes(recording)),
    }


def ends_of_nodes(recording: Recording) -> NDArray[np.int64]:
    """(n,): BODY or LID, the end that is held in each node; BODY where none is."""
    shown, holding = recording.presentations, recording.nodes.holding
    own = np.arange(len(holding))
    lid = shown.lid[recording.presentation_of(own)]
    return np.where(holding == lid, LID, BODY)
