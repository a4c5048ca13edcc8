"""What a command writes, one write per text."""

from __future__ import annotations

from edulaunch.processes.current import current_process


def say(text: str = '', end: str = '\n') -> None:
    """Write a line to the command's standard output."""
    current_process().stdout.write(text + end)


def complain(text: str) -> None:
    """Write a line to the command's standard error."""
    current_process().stderr.write(text + '\n')


def with_help(text: str, help: str | None) -> str:
    """An error text, with one line that says what to try when there is one."""
    return text if help is None else f'{text}\n  help: {help}'
