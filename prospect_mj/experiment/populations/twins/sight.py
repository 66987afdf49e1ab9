"""What linear kernels know of the features, whatever picture is shown."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.features import N_BINS
from prospect_mj.agent.haptics import categories_of_features, haptic_bits
from prospect_mj.experiment.populations.kernels.sums import Order, order_of, spans_of


class Sight(NamedTuple):
    """Haptic bits and zeros of features, in h haptic states of K categories."""

    bits: NDArray[np.bool_]
    """(h, 2 + K): which haptic bits a state has."""
    order: Order
    """In which products with features are added up."""
    spans: NDArray[np.int64]
    """(h, parts, 2): where features can be other than zero."""


def sight(n_features: int) -> Sight:
    """What there is to know of features of a length, in either of their readings.

    Raises:
        InvalidValue: if no number of categories makes features of this length.
    """
    bits = haptic_bits(categories_of_features(n_features))
    order = order_of(n_features)
    features = [_with_a_picture(row) for row in bits]
    return Sight(bits, order, spans_of(np.stack(features), order))


def _with_a_picture(bits: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """(n,): which features are other than zero where no bin of the histogram is."""
    blocks = np.repeat([True, *bits], N_BINS)
    return np.concatenate([blocks, bits, [True]])
