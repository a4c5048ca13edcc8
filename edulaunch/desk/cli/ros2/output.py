"""What commands write, one write per text, and numbers that they are given."""

from __future__ import annotations

import argparse
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
    """An error text, with one line that says what to try when there is one."""
    return text if help is None else f'{text}\n  help: {help}'


def say_lines(lines: Sequence[str]) -> None:
    """Print each on a line of its own."""
    for line in lines:
        say(line)


def positive_float(text: str) -> float:
    """A number above zero. Raises ArgumentTypeError for others, with the text of ROS 2."""
    return _positive(float(text))


def positive_int(text: str) -> int:
    """A whole number above zero. Raises ArgumentTypeError for others, with the text of ROS 2."""
    return _positive(int(text))


def _positive(value: Number) -> Number:
    if value <= 0:
        raise argparse.ArgumentTypeError('Value must be positive')
    return value
