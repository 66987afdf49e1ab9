"""What Rerun's viewer shows, as a picture, without a window."""

import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from rerun.experimental import ViewerClient

from prospect_mj.replay.timeline import TIMELINE
from prospect_mj.replay.viewer import HOST, failure, free_port, program, quiet

_PATIENCE, _POLL = 60.0, 0.25
"""For the viewer to answer, and for its picture to come to rest [s]."""
_REST = 1.0
"""Between two pictures that are to be the same [s]."""

_Answer = TypeVar("_Answer")


def photograph(file: Path, png: Path, seconds: float = 0.0) -> None:
    """Save what the viewer shows of an .rrd file.

    Args:
        file: the recording.
        png: the picture, 1920 by 1080; replaced if it is there.
        seconds: time at which it is shown.

    Raises:
        ChildProcessError: if the viewer fails, as without a driver for Vulkan.
    """
    port = free_port()
    command = [program(), "--headless", "--hide-welcome-screen", "--port", str(port)]
    with subprocess.Popen(
        command,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        env=quiet(),
    ) as process:
        try:
            client = _insist(
                process, lambda: ViewerClient(f"rerun+http://{HOST}:{port}/proxy")
            )
            for ask in (
                client.get_state,
                lambda: client.open(str(file.resolve())),
                lambda: client.set_time(
                    TIMELINE, duration=seconds, play_state="paused"
                ),
            ):
                _insist(process, ask)
            _save_at_rest(process, client, png)
        except (ConnectionError, TimeoutError) as error:
            raise ChildProcessError(_why_gone(process, error)) from error
        finally:
            process.kill()


def _why_gone(process: "subprocess.Popen[str]", error: OSError) -> str:
    """Why a viewer answers no more: it dies of what it says last."""
    try:
        _, said = process.communicate(timeout=_REST)
    except subprocess.TimeoutExpired:
        return f"Rerun's viewer does not answer: {error}"
    return failure(process.returncode, said)


def _insist(process: "subprocess.Popen[str]", ask: Callable[[], _Answer]) -> _Answer:
    """Ask again while a viewer that lives does not answer, as on a busy machine."""
    end = time.monotonic() + _PATIENCE
    while True:
        try:
            return ask()
        except (ConnectionError, TimeoutError):
            if process.poll() is not None or time.monotonic() > end:
                raise
            time.sleep(_POLL)


def _save_at_rest(
    process: "subprocess.Popen[str]", client: ViewerClient, png: Path
) -> None:
    """Views come in one by one: until two pictures in a row are the same."""
    end, before = time.monotonic() + _PATIENCE, None
    while time.monotonic() < end:
        time.sleep(_REST)
        _insist(process, lambda: client.save_screenshot(str(png.resolve())))
        now = png.read_bytes()
        if now == before:
            return
        before = now
