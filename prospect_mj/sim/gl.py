"""Off-screen OpenGL: which backend MuJoCo renders with, and whether it works.

MuJoCo and dm_control choose their backend from `MUJOCO_GL` when they are imported
(https://mujoco.readthedocs.io/en/stable/programming/#using-opengl) and fall back on
GLFW, which needs a display. `configure` therefore comes before them; where it can't,
it repairs the choice.
"""

import functools
import importlib
import os
import sys
import warnings

from prospect_mj.errors import RenderingUnavailable

DEBIAN_PACKAGES = ("libegl1", "libegl-mesa0", "libgl1-mesa-dri", "libopengl0")
"""EGL, its Mesa driver, the software rasteriser, and the library PyOpenGL binds to."""

_BACKEND = "MUJOCO_GL"
_RENDERER = "mujoco.rendering.classic.renderer"
_CONTEXT = "mujoco.rendering.classic.gl_context"


def configure() -> None:
    """Choose EGL on Linux; a backend that the user set in `MUJOCO_GL` always wins.

    Idempotent and cheap: call it before anything imports mujoco or dm_control, and
    again before a renderer is made.

    Raises:
        RenderingUnavailable: if mujoco was imported before, with another backend, and
            EGL can't be loaded any more.
    """
    if sys.platform != "linux":
        return
    if not os.environ.get(_BACKEND):
        os.environ[_BACKEND] = "egl"
    if os.environ[_BACKEND].strip().lower() == "egl":
        _rebind_renderer()


def _rebind_renderer() -> None:
    """Give a `mujoco.Renderer` that was imported too early the EGL context.

    A caller's own `import mujoco` may stand above his import of this package; MuJoCo
    has then bound GLFW for the whole process and offers no other way to change it.
    """
    renderer = sys.modules.get(_RENDERER)
    if renderer is None or renderer.GLContext.__module__ == "mujoco.egl":
        return
    try:
        context = importlib.reload(sys.modules[_CONTEXT])
    except Exception as error:
        raise RenderingUnavailable(_advice(error)) from error
    renderer.GLContext = sys.modules["mujoco"].GLContext = context.GLContext


@functools.cache
def renderer_name() -> str:
    """The GL_RENDERER string of an off-screen context, after one rendered image.

    Raises:
        RenderingUnavailable: if no image can be rendered; the message says why and
            names the packages to install.
    """
    configure()
    try:
        return _render_probe()
    # PyOpenGL and MuJoCo answer a missing library with AttributeError, ArgumentError,
    # ImportError, RuntimeError, EGLError or FatalError, depending on which one it is.
    except Exception as error:
        raise RenderingUnavailable(_advice(error)) from error


def require_gl() -> None:
    """Refuse early, before anything is written, where no image can be rendered.

    Raises:
        RenderingUnavailable: as `renderer_name`.
    """
    renderer_name()


def _render_probe() -> str:
    """Render an empty scene and read GL_RENDERER from its context."""
    with warnings.catch_warnings():
        # GLFW warns of what the exception says anyway.
        warnings.simplefilter("ignore")
        return _rendered_by()


def _rendered_by() -> str:
    import mujoco

    model = mujoco.MjModel.from_xml_string("<mujoco/>")
    with mujoco.Renderer(model, height=8, width=8) as renderer:
        renderer.update_scene(mujoco.MjData(model))
        renderer.render()
        from OpenGL import GL

        return GL.glGetString(GL.GL_RENDERER).decode()


def _advice(error: Exception) -> str:
    """One line: what failed and what to do about it."""
    reason = " ".join(str(error).split()) or type(error).__name__
    return (
        f"no OpenGL context with {_BACKEND}={os.environ.get(_BACKEND, '')} ({reason}); "
        f"install the Debian packages {' '.join(DEBIAN_PACKAGES)} and leave "
        f"{_BACKEND} unset or set it to egl"
    )
