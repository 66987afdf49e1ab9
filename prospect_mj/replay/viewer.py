"""Rerun's viewer as a program: in a window or in a browser.

The program itself is run: the Python one in front of it keeps its exit code to itself.
"""

import errno
import importlib.util
import ipaddress
import os
import re
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import quote
from urllib.request import urlopen

from prospect_mj.checks import check_integer
from prospect_mj.errors import InvalidValue, MissingViewer
from prospect_mj.replay import tended

HOST, PORT = "127.0.0.1", 9090
"""Where a browser finds the viewer, unless told otherwise."""
VULKAN_PACKAGE = "mesa-vulkan-drivers"
"""Debian's, of the software renderer where there is no graphics card."""

_ADDRESS = "an IPv4 address of this machine, such as 127.0.0.1 or 0.0.0.0"
_PATIENCE, _POLL = 30.0, 0.1
"""For a server to answer [s]."""
_NO_DRIVER = ("graphics adapter", "render context")
_STYLE = re.compile(r"\x1b\[[0-9;]*m")


def program() -> Path:
    """The viewer's executable.

    Raises:
        MissingViewer: if it is not installed.
    """
    found = importlib.util.find_spec("rerun_cli")
    name = "rerun.exe" if sys.platform == "win32" else "rerun"
    if found is not None and found.origin is not None:
        path = Path(found.origin).with_name(name)
        if path.is_file():
            return path
    raise MissingViewer("Rerun's viewer is not installed: pip install rerun-sdk")


def show(files: Sequence[Path]) -> None:
    """Open the viewer in a window, and wait until it is closed.

    Raises:
        ChildProcessError: if it fails.
    """
    # A port of its own: a viewer that is open already would take the files over.
    _run("--port", "auto", *files)


def serve(
    files: Sequence[Path],
    host: str,
    port: int,
    ready: Callable[[str], None],
    passing: Path | None = None,
) -> None:
    """Let browsers look, until the process is interrupted; also when it is killed.

    Args:
        files: what they see.
        host: address on which it listens; 0.0.0.0: on all that the machine has.
        port: of the page; the data come from the next one.
        ready: told the page's address when it is there.
        passing: a folder that goes with the server; None: there is none.

    Raises:
        InvalidValue: if the address is none, or one of the ports is taken.
        ChildProcessError: if the server fails.
    """
    check_port_free(host, port)
    name = socket.gethostname() if host == "0.0.0.0" else host
    options = ["--bind", host, "--port", port + 1, "--web-viewer-port", port]
    options += ["--cors-allow-origin", f"http://{name}:{port}"]
    command = _command("--serve-web", *options, *files)
    with _tended(command, passing) as server:
        if _answers(server, f"http://{host}:{port}"):
            data = quote(f"rerun+http://{name}:{port + 1}/proxy", safe="")
            ready(f"http://{name}:{port}/?url={data}")
        said = server.stderr.read()
        raise ChildProcessError(failure(server.wait(), said))


def free_port() -> int:
    """A port on which nobody listens at present."""
    with socket.create_server((HOST, 0)) as found:
        return found.getsockname()[1]


def check_port_free(host: str, port: int) -> None:
    """Refuse a port that is taken, or whose successor is.

    Args:
        host: address on which it is to be free.
        port: its number.

    Raises:
        InvalidValue: if one of them is taken, or the address is no IPv4 one of this
            machine.
    """
    _check_address(host)
    check_integer("--port", port, 1, 2**16 - 2)
    for number in (port, port + 1):
        try:
            with socket.create_server((host, number)):
                pass
        except OSError as error:
            if error.errno == errno.EADDRNOTAVAIL:
                raise InvalidValue("--host", host, _ADDRESS) from error
            free = f"a free one on {host}, and the next one free too"
            raise InvalidValue("--port", port, f"{free} ({error.strerror})") from error


def _check_address(host: str) -> None:
    """Rerun's viewer knows no names of hosts."""
    try:
        ipaddress.IPv4Address(host)
    except ValueError as error:
        raise InvalidValue("--host", host, _ADDRESS) from error


_CAPTURED = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, "text": True}


def _run(*arguments: object) -> None:
    done = subprocess.run(_command(*arguments), env=quiet(), check=False, **_CAPTURED)
    if done.returncode != 0:
        raise ChildProcessError(failure(done.returncode, done.stderr))


@contextmanager
def _tended(
    command: Sequence[str], folder: Path | None
) -> "Iterator[subprocess.Popen[str]]":
    """A program that ends with what follows, or with this process; see `tended`."""
    tender = [sys.executable, "-I", tended.__file__, str(folder or "")]
    with subprocess.Popen(
        [*tender, *command], env=quiet(), stdin=subprocess.PIPE, **_CAPTURED
    ) as running:
        # Leaving closes its standard input.
        yield running


def _command(*arguments: object) -> list[str]:
    return [str(program()), *map(str, arguments)]


def quiet() -> dict[str, str]:
    """The environment, with errors as all that the viewer writes about itself."""
    return {"RUST_LOG": "error", **os.environ}


def _answers(server: "subprocess.Popen[str]", page: str) -> bool:
    """Wait until the page is there; false if the server has ended before.

    Raises:
        ChildProcessError: if it runs and does not answer.
    """
    end = time.monotonic() + _PATIENCE
    while server.poll() is None:
        if time.monotonic() > end:
            raise ChildProcessError(
                f"Rerun's server did not answer in {_PATIENCE:.0f} s"
            )
        try:
            with urlopen(page, timeout=_PATIENCE):
                return True
        except OSError:
            time.sleep(_POLL)
    return False


def failure(code: int, said: str) -> str:
    """One line: what failed, and what to do about it where that is known."""
    lines = [line.strip() for line in _STYLE.sub("", said).splitlines() if line.strip()]
    if any(words in line for words in _NO_DRIVER for line in lines):
        return (
            "Rerun's viewer found no graphics driver; without a graphics card install "
            f"Debian's {VULKAN_PACKAGE}"
        )
    reason = _first(lines, ("Error", "error", "panicked"))
    return f"Rerun's viewer ended with code {code}: {reason}"


def _first(lines: Sequence[str], words: Iterable[str]) -> str:
    for word in words:
        for line in lines:
            if word in line and "XDG_RUNTIME_DIR" not in line:
                return line
    return lines[-1] if lines else "it said nothing"
