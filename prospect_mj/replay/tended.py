"""`tended.py FOLDER PROGRAM ...`: a program that ends with the process that runs it.

A process that is killed can end nothing any more. Its end of the pipe, which is this
one's standard input, is closed by the system, though. Run as a file, it loads nothing
of the package.
"""

import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from threading import Event, Thread

_PATIENCE = 5.0
"""For a program that was asked to end [s]."""


def main(arguments: Sequence[str]) -> int:
    """Run a program until it ends, or standard input does.

    Args:
        arguments: a folder, which is removed in the second case (empty: none), and the
            command.

    Returns:
        The program's exit code; as a shell's, if a signal ended it.
    """
    folder, *command = arguments
    # Ctrl-C is for the process that runs this one, and ends this one by it. A handler,
    # as the program would inherit that it is ignored.
    signal.signal(signal.SIGINT, lambda *_: None)
    program, is_alone = subprocess.Popen(command, stdin=subprocess.DEVNULL), Event()
    Thread(target=_end_with_input, args=(program, is_alone), daemon=True).start()
    code = program.wait()
    if is_alone.is_set():
        shutil.rmtree(folder, ignore_errors=True)
    return code if code >= 0 else 128 - code


def _end_with_input(program: "subprocess.Popen[bytes]", is_alone: Event) -> None:
    sys.stdin.read()
    is_alone.set()
    program.terminate()
    time.sleep(_PATIENCE)
    # It has not ended yet, nor has this process.
    program.kill()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
