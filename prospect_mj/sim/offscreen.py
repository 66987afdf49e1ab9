"""Rendering into memory, by any number of renderers in one process."""

import mujoco


class OffscreenRenderer(mujoco.Renderer):
    """MuJoCo's renderer, which leaves others alone when it is closed."""

    def close(self) -> None:
        """Give the OpenGL context back; closing again does nothing."""
        # OpenGL's objects are freed by number, and in the context that is current: in
        # another renderer's they would be that one's.
        if self._gl_context is not None:
            self._gl_context.make_current()
        super().close()
