"""What lasts is shown until it ends, or until something follows at once."""

from typing import NamedTuple

import pytest

from prospect_mj.replay.timeline import changes


class Span(NamedTuple):
    start: float
    end: float


def test_a_gap_is_told_where_nothing_follows_at_once():
    spans = [Span(0.0, 1.0), Span(1.0 + 1e-9, 2.0), Span(3.0, 4.0)]
    assert list(changes(spans)) == [
        (0.0, 0),
        (1.0 + 1e-9, 1),
        (2.0, None),
        (3.0, 2),
        (4.0, None),
    ]


@pytest.mark.parametrize(
    ("spans", "expected"),
    [
        # A hand that is open already as the arm begins to reach.
        (
            [Span(0.0, 0.44), Span(0.0, 0.02), Span(0.44, 1.68)],
            [(0.0, 0), (0.44, 2), (1.68, None)],
        ),
        (
            [Span(0.0, 3.0), Span(1.0, 2.0)],
            [(0.0, 0), (1.0, 1), (2.0, 0), (3.0, None)],
        ),
    ],
)
def test_what_goes_on_is_shown_when_something_shorter_has_ended(spans, expected):
    assert list(changes(spans)) == expected


@pytest.mark.parametrize("spans", [[], [Span(1.0, 1.0)]])
def test_nothing_changes_where_nothing_lasts(spans):
    assert list(changes(spans)) == []
