"""Values of contexts, and what they become when one splits."""

import numpy as np
import pytest
from two_kinds import BRIGHT, DARK, visual

from prospect_mj.agent import DiscoverySettings
from prospect_mj.agent.discovery.contexts import WHOLE, Contexts
from prospect_mj.agent.discovery.detector import Detector
from prospect_mj.agent.discovery.examples import Example, Examples
from prospect_mj.agent.discovery.feature import Feature, cumulative
from prospect_mj.agent.discovery.values import Values

HERE = (0, 0)
PICTURE = {kind: cumulative(visual(kind)) for kind in (DARK, BRIGHT)}
TELLS = Detector(Feature(50, 60, 0, 0), 1.0, 1.0, np.array([0, 20]), np.array([20, 20]))
FIRST_ONLY, SECOND_ONLY = np.array([True, False]), np.array([False, True])


class Known:
    """Two haptic states, two actions; after action 0 comes the second state."""

    def __init__(self, **settings):
        self.settings = DiscoverySettings(
            n_haptic=2, n_actions=2, discount=0.5, memory=2, **settings
        )
        self.contexts = Contexts.whole(self.settings)
        self.examples = Examples.none(self.settings)
        self.values = Values(self.settings, self.contexts, self.examples)
        self.contexts.mean[:] = [[-6, 0], [-2, -4]]
        self.contexts.count[:] = 9

    def remember(self, kind, allowed, terminated=False):
        example = Example(PICTURE[kind], kind, -1.0, 1, terminated, allowed, -8.0)
        self.examples.add(HERE, kind, example)


def test_rates_are_those_of_an_average_until_they_are_least():
    contexts = Contexts.whole(DiscoverySettings())
    for target, mean in ((-1, -1), (-3, -2), (-6, -2 - 4 * 0.4)):
        contexts.learn(HERE, WHOLE, target, least=0.4)
        assert contexts.mean[HERE] == pytest.approx(mean)
    contexts.learn(HERE, BRIGHT, -5.0, least=0.4)
    assert contexts.leaf_value[HERE].tolist() == [0, -5]


def test_examples_are_valued_by_the_choices_and_values_of_today():
    known = Known()
    known.remember(DARK, FIRST_ONLY)
    known.remember(DARK, SECOND_ONLY)
    known.remember(BRIGHT, FIRST_ONLY, terminated=True)
    known.values.split(HERE, [TELLS], trial=17)
    # Dark: -1 + .5 x -2 and -1 + .5 x -4.
    assert known.contexts.leaf_value[HERE].tolist() == [-2.5, -1.0]
    assert known.contexts.leaf_count[HERE].tolist() == [2, 1]
    assert known.contexts.first_split[HERE] == 17
    assert known.values.of(0, PICTURE[BRIGHT], 0).tolist() == [-1, 0]


def test_what_follows_is_valued_by_the_leaf_of_the_same_picture():
    known = Known()
    known.contexts.put((1, 0), [TELLS])
    known.contexts.leaf_value[1, 0] = [-10, -20]
    known.remember(DARK, FIRST_ONLY)
    known.remember(BRIGHT, FIRST_ONLY)
    known.values.split(HERE, [TELLS], trial=0)
    assert known.contexts.leaf_value[HERE].tolist() == [-6, -11]


@pytest.mark.parametrize(("revalue", "values"), [("stored", -8), ("inherit", -6)])
def test_leaves_may_be_of_old_targets_or_of_the_old_value(revalue, values):
    known = Known(revalue=revalue)
    known.remember(DARK, FIRST_ONLY)
    known.remember(BRIGHT, FIRST_ONLY)
    known.values.split(HERE, [TELLS], trial=0)
    assert known.contexts.leaf_value[HERE].tolist() == [values, values]


def test_a_leaf_without_examples_inherits():
    known = Known()
    known.remember(DARK, FIRST_ONLY)
    known.values.split(HERE, [TELLS], trial=0)
    assert known.contexts.leaf_value[HERE].tolist() == [-2, -6]
    # And its first target will replace it.
    assert known.contexts.leaf_count[HERE].tolist() == [1, 0]


def test_a_second_split_leaves_a_leaf_without_examples_as_it_was():
    known = Known()
    known.values.split(HERE, [TELLS], trial=0)
    known.contexts.leaf_value[HERE] = [-7, -9]
    known.remember(DARK, FIRST_ONLY)
    known.values.split(HERE, [TELLS, TELLS], trial=5)
    assert known.contexts.leaf_value[HERE].tolist() == [-2, -9]
    assert known.contexts.first_split[HERE] == 0


def test_the_newest_example_takes_the_place_of_the_oldest():
    known = Known()
    for allowed in (SECOND_ONLY, SECOND_ONLY, FIRST_ONLY):
        known.remember(DARK, allowed)
    assert known.examples.number(HERE, DARK) == 2
    remembered = [one.allowed.tolist() for one in known.examples.of(HERE)]
    assert remembered == [FIRST_ONLY.tolist(), SECOND_ONLY.tolist()]
