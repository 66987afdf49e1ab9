"""What is wrong with options, in the project's words and not in the parser's."""

import operator
import re
from collections.abc import Sequence
from itertools import dropwhile, takewhile

_ESCAPE = re.compile(r"\x1b\[[0-9;]*m")
# What tyro puts before an option or before a dataclass's own words.
_PARSING = re.compile(r"^Error parsing (?:[A-Za-z_][\w.]*: )?")
_RULE = re.compile(r"-{4,}")
_FRAME = "╭╮╰╯│─ \t"
_NAMED = re.compile(r"[a-z][\w ]*?(?= is )")

_WHOLE = r"\1 is \2; expected a whole number"
_SAID = {
    r"(\S+): invalid literal for int\(\) with base 10: (.*)": _WHOLE,
    r"(\S+): no type matching INT could be instantiated from \[(.*)\]\.": _WHOLE,
    r"(\S+): could not convert string to float: (.*)": r"\1 is \2; expected a number",
    r"(--[\w.-]+): [a-z ]+ is (.*)": r"\1 is \2",
    r"Missing value for argument '(.*)'\. Expected 1 values\.": (
        r"\1 is given without a value"
    ),
}
"""What tyro and Python say, or a type's own words, and what is said in its place."""
_CHOICE = r"invalid choice (.*) for argument '(.*)'\. Expected one of \((.*?),?\)\."


def of_box(drawn: str) -> str:
    """One line of the box that tyro draws where it refuses options.

    Args:
        drawn: all of it, with its frame and colours.
    """
    line = _first_section(drawn)
    for pattern, words in _SAID.items():
        if found := re.fullmatch(pattern, line):
            return found.expand(words)
    if found := re.fullmatch(_CHOICE, line):
        value, option, choices = found.groups()
        valid = choices.replace("'", "")
        return f"{option} is {value}; valid: {valid}"
    return line


def as_typed(message: str, argv: Sequence[str]) -> str:
    """A message about a setting, with the option that it was given by for its name.

    Args:
        message: such as `runs is 0; expected ...`.
        argv: the arguments that were given.
    """
    named = _NAMED.match(message)
    for word in argv if named else ():
        option = word.partition("=")[0]
        setting = option.rpartition(".")[2].removeprefix("--")
        if option.startswith("--") and _words(setting) == _words(named[0]):
            return option + message[named.end() :]
    return message


def _words(name: str) -> list[str]:
    return re.split("[-_ ]", name)


def _first_section(box: str) -> str:
    """The text of a box below its title, down to the next rule, without the frame."""
    lines = [line.strip(_FRAME) for line in _ESCAPE.sub("", box).splitlines()]
    # Where the terminal has no box characters, a rule is dashes, also below the title.
    ruled = ["" if _RULE.fullmatch(line) else line for line in lines[1:]]
    text = dropwhile(operator.not_, ruled)
    return _PARSING.sub("", " ".join(takewhile(bool, text)))
