"""What a command prints: words for people, or one JSON object for programs."""

import json
import math
import sys
from collections.abc import Mapping
from dataclasses import dataclass, fields, is_dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import tyro
from tqdm import tqdm


@dataclass(frozen=True)
class Output:
    """Who reads the result; put it into a command's options under the name ""."""

    json: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False
    """Print the result as one JSON object on stdout; all other words go to stderr."""

    def say(self, words: str) -> None:
        """Tell a person something at once, where no program will read it."""
        print(words, file=sys.stderr if self.json else sys.stdout, flush=True)

    def result(self, words: str, figures: object) -> None:
        """Print the result.

        Args:
            words: for people; none if all has been said.
            figures: for programs: a dataclass or a mapping, which becomes an object.
        """
        text = as_json(figures) if self.json else words
        if text:
            print(text, flush=True)


def say_aside(words: str) -> None:
    """Tell a person something on stderr, beside a bar that may be there."""
    tqdm.write(words, file=sys.stderr)
    sys.stderr.flush()


def counted(number: int, noun: str) -> str:
    """So many of something, such as `1 action` or `3 actions`."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def as_json(figures: object) -> str:
    """One JSON object in one line; a number that is not finite becomes null."""
    return json.dumps(plain(figures), ensure_ascii=False, allow_nan=False)


def plain(value: object) -> Any:  # noqa: ANN401
    """The same of nothing but what JSON has."""
    if is_dataclass(value):
        parts = fields(value)
        return {part.name: plain(getattr(value, part.name)) for part in parts}
    if isinstance(value, Mapping):
        return {str(name): plain(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [plain(part) for part in value]
    if isinstance(value, np.ndarray | np.generic):
        return plain(value.tolist())
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return str(value) if isinstance(value, Path) else value
