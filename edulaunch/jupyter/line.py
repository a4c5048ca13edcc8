"""A line behind `%ros2`: the words, and what we add to a shell's."""

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
    """What a line says.

    :ivar words: behind `ros2`, without our own options and the last `&`.
    :ivar seconds, seed: of `--for` and `--seed`, if they are given.
    :ivar stays: whether it ends in `&`: the command goes on beside the next ones.
    :ivar quiet: whether a launch or a run is to say nothing, neither its console nor mistakes that are found (`--quiet`).
    :ivar shell: the text, when commands are joined as in a shell; else empty.
    """

    words: list[str]
    seconds: float | None
    seed: int
    stays: bool
    shell: str
    quiet: bool = False


def read_line(text: str) -> Line:
    """Read a line.

    :raises UnusableInput: for words that cannot be read.
    """
    try:
        words = shlex.split(text)
        lexer = shlex.shlex(text, posix=False, punctuation_chars=SHELL_SIGNS)
        lexer.whitespace_split = True
        signs = [word for word in lexer if not set(word) - set(SHELL_SIGNS)]
    except ValueError as error:
        raise UnusableInput(f'cannot read this command: {error}', help='a quotation mark is missing its partner') from None
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
    """The number behind an option of ours, which is taken out of the words; None when it is not there."""
    if option not in words:
        return None
    position = words.index(option)
    _, *value = words[position : position + 2]
    del words[position : position + 2]
    return number_of(value[0] if value else None, option)


def number_of(text: str | None, name: str) -> float:
    """A number of simulated seconds.

    :raises UnusableInput: for anything else.
    """
    try:
        number = -1.0 if text is None else float(text)
    except ValueError:
        number = -1.0
    if not 0 <= number <= 1e6:
        raise UnusableInput(f'{name} needs a number from 0 to 1000000, not {text or "nothing"!r}', help=f'for example: {name} 5')
    return number
