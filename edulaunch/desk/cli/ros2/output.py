"""Functions that print the output of commands with one write for each message, and functions that read numbers."""

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
    """Return an error message. If `help` is not None, add a line with that suggestion."""
    return text if help is None else f'{text}\n  help: {help}'


def say_lines(lines: Sequence[str]) -> None:
    """Print each string as one line."""
    for line in lines:
        say(line)


def positive_float(text: str) -> float:
    """Convert a string to a positive number.

    :raises ArgumentTypeError: for a number that is not positive, with the message of ROS 2.
    """
    return _positive(float(text))


def positive_int(text: str) -> int:
    """Convert a string to a positive whole number.

    :raises ArgumentTypeError: for a number that is not positive, with the message of ROS 2.
    """
    return _positive(int(text))


def _positive(value: Number) -> Number:
    if not 0 < value < math.inf:
        raise argparse.ArgumentTypeError('Value must be positive')
    return value
