"""A look must not hang on the order in which a processor adds numbers up."""

import os
import pickle
import subprocess
import sys

import numpy as np
import pytest

pytestmark = pytest.mark.gl

LOOK_AGAIN = """
import pickle, sys
from prospect_mj.vision.vision_controller import VisionController
eyes, pairs = pickle.load(sys.stdin.buffer)
looks = [VisionController(*eyes).look(pair) for pair in pairs]
found = [(look.position, look.axis, look.histogram, look.masks) for look in looks]
sys.stdout.buffer.write(pickle.dumps(found))
"""
OLD_PROCESSOR = {"OPENBLAS_CORETYPE": "Nehalem", "OPENCV_CPU_DISABLE": "AVX2,FMA3"}
"""Without fused and wide arithmetic; other machines than PCs have no such choice."""


def test_an_old_processor_sees_the_same(stage, gallery):
    """Rounding may move the pose by much less than what makes a grasp another one."""
    eyes, seen = (stage.camera.left, stage.camera.right), gallery[:20]
    done = subprocess.run(
        [sys.executable, "-c", LOOK_AGAIN],
        input=pickle.dumps((eyes, [p.pair for p in seen])),
        env=os.environ | OLD_PROCESSOR,
        capture_output=True,
        check=True,
    )
    for here, (position, axis, histogram, masks) in zip(
        seen, pickle.loads(done.stdout), strict=True
    ):
        np.testing.assert_allclose(position, here.look.position, rtol=0, atol=1e-8)
        np.testing.assert_allclose(axis, here.look.axis, rtol=0, atol=1e-8)
        np.testing.assert_array_equal(histogram, here.look.histogram)
        np.testing.assert_array_equal(masks, here.look.masks)
