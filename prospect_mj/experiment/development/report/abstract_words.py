"""Numbers of the abstract task beside the recorded ones, in words."""

from math import isnan

from prospect_mj.experiment.development.study.abstract_besides import Beside
from prospect_mj.experiment.development.study.abstract_compared import Compared
from prospect_mj.experiment.development.study.abstract_told import Abstract
from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.paper.measures.quantity import number, with_interval


def told_words(each: Compared, told: Abstract) -> str:
    """A number of the abstract task."""
    return number(each.said(told), each.kind) if each.is_told(told) else "-"


def found_words(each: Compared, one: Measured) -> str:
    """That of a row, with its interval if it has one."""
    found = each.found(one)
    if found.low == found.high == found.estimate and not isnan(found.low):
        return number(found.estimate, each.kind)
    return with_interval(found, each.kind)


def both(each: Compared, one: Beside) -> str:
    """Both, with a mark where they aren't the same."""
    words = f"{told_words(each, one.told)} / {found_words(each, one.recorded)}"
    if each in one.differing():
        return f"**{words}**"
    return f"*{words}*" if each in one.outside() else words
