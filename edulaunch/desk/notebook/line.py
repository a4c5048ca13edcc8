"""Parse a line after `%ros2`: its words, and the options that `ros2` itself does not have."""

from __future__ import annotations

import re
import shlex
from typing import NamedTuple

from edulaunch.errors import UnusableInput
from edulaunch.runtime.shell.grammar import stands_for_more

SHELL_SIGNS = '|&;<>'
QUIET = '--quiet'
_OURS = re.compile(r'\s--(for|seed)\s+\S+')


class Line(NamedTuple):
    """The parts of a line after `%ros2`.

    :ivar words: the words after `ros2`, without the options of the magic and the `&` at the end.
    :ivar seconds: the value of `--for` in simulated seconds, or None.
    :ivar seed: the value of `--seed`, or 0.
    :ivar stays: whether the line ends with `&`, so that the command runs in the background.
    :ivar quiet: whether a launch or a run hides its console and its advice (`--quiet`).
    :ivar shell: the whole line if it joins commands as in a shell, otherwise an empty string.
    """

    words: list[str]
    seconds: float | None
    seed: int
    stays: bool
    shell: str
    quiet: bool = False


def read_line(text: str) -> Line:
    """Return the parts of a line after `%ros2`.

    :raises UnusableInput: when the words cannot be parsed.
    """
    try:
        words = shlex.split(text)
        lexer = shlex.shlex(text, posix=False, punctuation_chars=SHELL_SIGNS)
        lexer.whitespace_split = True
        signs = [word for word in lexer if not set(word) - set(SHELL_SIGNS)]
    except ValueError as error:
        raise UnusableInput(f'cannot read this command: {error}', help='add the missing quotation mark') from None
    stays = signs[-1:] == ['&'] and text.rstrip().endswith('&')
    if stays:
        signs.pop()
        text = text.rstrip()[:-1]
        words = shlex.split(text)
    seconds, seed = _take_number(words, '--for'), _take_number(words, '--seed')
    shell = _OURS.sub('', text).strip() if signs or stands_for_more(text) else ''
    quiet = QUIET in words and words[:1] in (['launch'], ['run'])
    if quiet:
        words.remove(QUIET)
    return Line(words, seconds, int(seed or 0), stays, shell, quiet)


def _take_number(words: list[str], option: str) -> float | None:
    """Return the number after an option of the magic, or None without the option.

    Remove the option and the number from the words.
    """
    if option not in words:
        return None
    position = words.index(option)
    _, *value = words[position : position + 2]
    del words[position : position + 2]
    return number_of(value[0] if value else None, option)


def number_of(text: str | None, name: str) -> float:
    """Return a number of simulated seconds that the user has typed.

    :param text: the string to convert, or None if it is missing.
    :param name: the name of the option for the error message.
    :raises UnusableInput: when the string is not a number from 0 to 1,000,000.
    """
    try:
        number = -1.0 if text is None else float(text)
    except ValueError:
        number = -1.0
    if not 0 <= number <= 1e6:
        raise UnusableInput(
            f'{name} needs a number from 0 to 1000000, not {text or "nothing"!r}', help=f'write, for example: {name} 5'
        )
    return number
