"""Draw a harmonic function over two joints for docs/gross_motion.md."""

import sys
from pathlib import Path

from prospect_mj.cli import draw
from prospect_mj.sim import gl

OUT = Path("docs/images/harmonic_field.png")


def field_picture() -> bytes:
    """The picture as PNG."""
    gl.require_gl()
    # dm_control, which composes the scene, needs OpenGL chosen before it is loaded.
    from prospect_mj.experiment import field_plot

    return field_plot.field_picture()


if __name__ == "__main__":
    sys.exit(draw.main(field_picture, OUT, "draw_field.py"))
