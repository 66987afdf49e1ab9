"""The exceptions of this package: programming and input errors, never control failure.

A controller that does not converge returns a value (`prospect_mj.control.result`);
an exception here means that the caller asked for something that does not exist.
"""

import errno
from collections.abc import Iterable


class ProspectError(Exception):
    """Base of every error that this package raises on purpose."""

    def __reduce__(self) -> tuple[object, ...]:
        """Pickle by message, as some are made from other arguments."""
        return _with_message, (type(self), str(self))


def _with_message(kind: type[ProspectError], message: str) -> ProspectError:
    return kind.__new__(kind, message)


_MACHINES = {errno.ENOSPC, errno.EDQUOT, errno.EIO, errno.EMFILE, errno.ENFILE}


class InputNotAtFault(ProspectError):
    """Base of what goes wrong whatever was asked for: the physics failed."""


def is_inputs_fault(error: Exception | None) -> bool:
    """Whether an error is of what was asked for, and not of physics or machine.

    A missing file that ships with the package is an `OSError` too; it counts as input,
    and so does whatever may not be read or written.
    """
    ours = isinstance(error, ProspectError | PermissionError)
    return ours and not isinstance(error, InputNotAtFault)


def is_machines_fault(error: OSError) -> bool:
    """Whether a file could not be written wherever it was to be: a full disk, say."""
    return error.errno in _MACHINES


def told(error: Exception) -> str:
    """What went wrong, in one line; a file that could not be had comes first."""
    if isinstance(error, OSError) and error.filename and error.strerror:
        return f"{error.filename}: {error.strerror}"
    return " ".join(str(error).split())


class InvalidChoice(ProspectError, ValueError):
    """A value that is not among the valid ones, which the message lists."""

    def __init__(self, what: str, value: object, valid: Iterable[object]) -> None:
        """Name the bad value and the valid ones."""
        choices = ", ".join(str(choice) for choice in valid)
        super().__init__(f"{what} is {value!r}; valid: {choices}")


class InvalidValue(ProspectError, ValueError):
    """A value outside of its range or of the wrong shape."""

    def __init__(self, what: str, value: object, expected: str) -> None:
        """Name the bad value and what was expected instead."""
        super().__init__(f"{what} is {value!r}; expected {expected}")


class UnfitCheckpoint(InvalidValue):
    """A learner that was read and can't be used: of another kind or version, say."""

    def __init__(self, message: str) -> None:
        """Say what is wrong with them."""
        ProspectError.__init__(self, message)


class MissingFile(ProspectError, FileNotFoundError):
    """A model or asset file that should ship with the package is not there."""


class InvalidModel(ProspectError):
    """A model or asset file that can't be read or compiled."""


class RunFolderError(ProspectError):
    """A run folder that cannot be used: foreign, unreadable, occupied or different."""


class RecordingError(ProspectError):
    """A recording that cannot be used: damaged, of other physics, or incomplete."""


class EpisodeError(ProspectError):
    """An episode that can't be read: missing, damaged or of another run."""


class ForeignTable(ProspectError):
    """A table file that holds something else than what it was read for."""


class FolderInUse(ProspectError):
    """A folder that another process works in."""


class RenderingUnavailable(ProspectError):
    """No OpenGL context can be made; the message names the package to install."""


class NoDisplay(ProspectError):
    """No window can be opened; the message says what to do instead."""


class MissingViewer(ProspectError):
    """Rerun's viewer is not installed."""


class MissingEncoder(ProspectError):
    """There is no ffmpeg to make a video with."""


class MissingPackage(ProspectError):
    """A package of an optional extra that is not installed."""

    def __init__(self, package: str, extra: str) -> None:
        """Name the package and the extra that brings it."""
        super().__init__(
            f"the package {package} is not installed; it comes with the extra "
            f"{extra}: pip install 'prospect-mj[{extra}]'"
        )


class SimulationDiverged(InputNotAtFault):
    """MuJoCo raised a warning (bad acceleration, full buffers): the physics is void."""


class UnfinishedRecording(InputNotAtFault):
    """Some trees could not be grown to their end; all others are there."""


class UnforeseenEvent(InputNotAtFault):
    """The robot observed what its discrete-event model says can't happen."""

    def __init__(self, event: str, state: str) -> None:
        """Name the event and the state in which it was not foreseen."""
        super().__init__(f"unforeseen event: {event}; it can't happen in: {state}")
