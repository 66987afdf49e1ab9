"""The report on infants."""

from collections.abc import Iterable

from prospect_mj.experiment.paper.measures import infants
from prospect_mj.experiment.paper.measures.quantity import Kind, with_interval
from prospect_mj.experiment.paper.measures.sample import Sample
from prospect_mj.experiment.paper.measures.stages import stages
from prospect_mj.experiment.paper.report.markdown import table

_ROWS = {
    "nonradial": "nonradial first grasps, of all first grasps in difficult trials",
    "easy_nonradial": "the same in easy trials",
    "optimal": "optimal in difficult trials",
    "early": "early corrections in difficult trials",
    "late": "late corrections in difficult trials",
    "other": "other or truncated in difficult trials",
    "preference": "early ones in all corrections of difficult trials",
    "easy_optimal": "optimal in easy trials",
}


def section(sample: Sample) -> Iterable[str]:
    """The order of strategies in infants and in the agent, a piece at a time."""
    yield "## Infants"
    yield (
        "Order only: the percentages of McCarty, Clifton and Collard (1999) were not "
        "at hand, and none is made up here. What is said of infants is what the paper "
        "tells of them (sections 2 and 3.2). A nonradial grasp is one by the hand that "
        "is not on the lid's side, and counts whatever comes of it."
    )
    found = stages(sample)
    heads = [f"trials {stage.first} to {stage.last}" for stage in found]
    yield table(
        ("the agent", *heads),
        [
            (
                words,
                *(with_interval(stage.measured(name), Kind.SHARE) for stage in found),
            )
            for name, words in _ROWS.items()
        ],
    )
    yield (
        "The three stages are the beginning after the pretraining, the height of "
        "corrections between it and the end, and the end; they stand for 9, 14 and 19 "
        "months. An order holds if the intervals put all of its parts beyond doubt, "
        "does not hold if they exclude one of them, and is undecided otherwise. "
        "When corrections disappear is measured in several ways, as above, and may "
        "depend on the measure."
    )
    yield table(
        ("infants, as the paper tells", "the same in the agent", "verdict"),
        [
            (order.infants, order.rule, f"**{order.verdict}**")
            for order in infants.orders(sample, found)
        ],
    )
