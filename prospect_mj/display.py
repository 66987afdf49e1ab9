"""Whether a window can be opened here; `python -m prospect_mj.display` tries to.

It is tried in a process of its own: MuJoCo's viewer waits for ever for a window that
can't be opened, and a driver may take the whole process down.
"""

import os
import subprocess
import sys

from prospect_mj.errors import NoDisplay

_VARIABLES = ("DISPLAY", "WAYLAND_DISPLAY")
_PROBE = ("-m", "prospect_mj.display")
_PATIENCE = 30.0
"""For a window to open [s]."""


def require_display(instead: str) -> None:
    """Refuse early, before anything is begun, where no window can be opened.

    Args:
        instead: what the user can do in place of looking at a window, as words that
            follow `; `.

    Raises:
        NoDisplay: with the reason and these words.
    """
    reason = why_no_window()
    if reason is not None:
        raise NoDisplay(f"{reason}; {instead}")


def why_no_window() -> str | None:
    """What keeps a window from opening; None: it opens."""
    if sys.platform == "linux" and not any(map(os.environ.get, _VARIABLES)):
        return f"there is no display: {' and '.join(_VARIABLES)} are not set"
    try:
        done = subprocess.run(
            [sys.executable, *_PROBE],
            capture_output=True,
            text=True,
            timeout=_PATIENCE,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return f"no window opened within {_PATIENCE:.0f} s"
    if done.returncode == 0:
        return None
    said = done.stderr.strip().splitlines() or [f"exit code {done.returncode}"]
    return f"no window can be opened: {said[-1]}"


def main() -> int:
    """Open a window that nobody sees; 0 if there was one."""
    import glfw

    said: list[bytes] = []
    glfw.set_error_callback(lambda code, words: said.append(words))
    glfw.init()
    glfw.window_hint(glfw.VISIBLE, glfw.FALSE)
    window = glfw.create_window(64, 64, "prospect", None, None)
    if not window:
        reason = said[0].decode(errors="replace") if said else "GLFW gave no reason"
        print(reason, file=sys.stderr)
        return 1
    glfw.terminate()
    return 0


if __name__ == "__main__":
    sys.exit(main())
