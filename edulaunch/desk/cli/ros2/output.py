"""The output of commands, one write per message, and the numbers in their arguments."""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence
from typing import TypeVar

from edulaunch.engine.processes.current import current_process

Number = TypeVar('Number', int, float)


def say(text: str = '', end: str = '\n') -> None:
    """Write a line to the command's standard output."""
    current_process().streams.stdout.write(text + end)


def complain(text: str) -> None:
    """Write a line to the command's standard error."""
    current_process().streams.stderr.write(text + '\n')


def with_help(text: str, help: str | None) -> str:
    """Return an error message, followed by a line that suggests what to try, if there is a suggestion."""
    return text if help is None else f'{text}\n  help: {help}'


def say_lines(lines: Sequence[str]) -> None:
    """Print each item on a line of its own."""
    for line in lines:
        say(line)


def positive_float(text: str) -> float:
    """Return a positive number. Raise ArgumentTypeError for others, with the message of ROS 2."""
    return _positive(float(text))


def positive_int(text: str) -> int:
    """Return a positive whole number. Raise ArgumentTypeError for others, with the message of ROS 2."""
    return _positive(int(text))


def _positive(value: Number) -> Number:
    if not 0 < value < math.inf:
        raise argparse.ArgumentTypeError('Value must be positive')
    return value
