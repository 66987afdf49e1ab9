"""Which trials are kept, in words, and where they are."""

import pytest

from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.run.kept_episodes import Kept, kept_trials, path_of


@pytest.mark.parametrize(
    ("words", "every"),
    [("all", 1), ("failures", None), ("every=1", 1), ("every=50", 50)],
)
def test_words_are_read(words, every):
    assert Kept.parse(words) == Kept(every)


@pytest.mark.parametrize(
    "words",
    [
        *("", "none", "all=", "all=1", "failures=2", "every", "every=", "every=a"),
        *("every=-1", "every=1.5", "every=٣", "every=²"),
    ],
)
def test_what_is_none_is_named(words):
    with pytest.raises(InvalidValue, match=r"--record is .*; expected all, failures"):
        Kept.parse(words)


@pytest.mark.parametrize("number", [0, 1_000_001])
def test_a_number_out_of_range_is_named(number):
    with pytest.raises(InvalidValue, match=f"N of every=N is {number}"):
        Kept.parse(f"every={number}")


@pytest.mark.parametrize("n_digits", [26, 5000])
def test_a_number_that_is_far_out_of_range_is_one_all_the_same(n_digits):
    with pytest.raises(InvalidValue, match=r"N of every=N is '9{20}\.\.\.'"):
        Kept.parse(f"every={'9' * n_digits}")


def test_files_of_other_names_are_no_trials(tmp_path):
    (tmp_path / "episodes").mkdir()
    for number in (12, 3):
        path_of(tmp_path, number).touch()
    for name in ("trial-.npz", "trial-٣.npz", "trial-a.npz", "notes.npz"):
        (tmp_path / "episodes" / name).touch()
    assert kept_trials(tmp_path) == [3, 12]
