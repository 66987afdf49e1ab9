"""`python -m prospect_mj.cli.check_gl`: whether images can be rendered, in one line."""

import os
import sys

from prospect_mj.errors import RenderingUnavailable
from prospect_mj.sim import gl


def main() -> int:
    """Print the renderer and return 0, or say what is missing and return 2."""
    try:
        name = gl.renderer_name()
    except RenderingUnavailable as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    print(f"OpenGL: {os.environ.get('MUJOCO_GL') or 'native'}, {name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
