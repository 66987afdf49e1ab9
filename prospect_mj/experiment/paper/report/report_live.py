"""The part of the report on live physics."""

from collections.abc import Iterable

from prospect_mj.experiment.paper.figures.captions import LIVE
from prospect_mj.experiment.paper.live.live_check import EXPECTED, LiveCheck
from prospect_mj.experiment.paper.measures.bootstrap import LEVEL

_VERDICTS = {
    True: "They agree",
    False: "They do not agree",
    None: f"Undecided, as {EXPECTED} complete runs are expected",
}


def section(live: LiveCheck | None) -> Iterable[str]:
    """How live runs compare with recorded ones, if there are any."""
    yield "## Live physics against recorded"
    if live is None:
        yield "Not compared: no live runs were given."
        return
    if live.deviation is None:
        yield f"Not compared: of {live.unfinished} live runs none is complete."
        return
    far = live.deviation
    yield (
        f"Complete runs on live physics: {live.runs}{_lacking(live)}. Their mean is "
        f"held against the simultaneous {100 * LEVEL:.0f} % band of means of as many "
        f"recorded runs. It is inside in {100 * far.inside:.1f} % of the sets of ten "
        f"trials. Where it is farthest from the centre, it is {far.largest:.2f} "
        f"standard deviations of such means away; the band reaches to {far.reach:.2f}. "
        f"As many recorded runs are as far away, or farther, with {_p(far.p_value)}. "
        f"**{_VERDICTS[live.agrees]}.**"
    )
    yield f"![Live runs on the band of recorded ones]({LIVE}.png)"
    yield f"*[Numbers]({LIVE}.parquet).*"


def _p(value: float) -> str:
    return f"p = {value:.3f}" if value >= 0.001 else "p < 0.001"


def _lacking(live: LiveCheck) -> str:
    """Which runs are not among those that are compared."""
    lacking = {
        "unfinished": live.unfinished,
        f"of the {EXPECTED} expected not begun": live.not_begun,
    }
    words = ", ".join(f"{number} {what}" for what, number in lacking.items() if number)
    return words and f" ({words})"
