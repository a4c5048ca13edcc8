"""Filters of output."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable

DEFAULT_FILTERED_PREFIXES = ['pid', 'rc']
DEFAULT_FILTERED_PATTERNS: list[str] = []


def get_default_filtered_prefixes() -> list[str]:
    """Beginnings of lines that say nothing about a program."""
    return list(DEFAULT_FILTERED_PREFIXES)


def get_default_filtered_patterns() -> list[str]:
    """Regular expressions of lines that say nothing about a program."""
    return list(DEFAULT_FILTERED_PATTERNS)


def basic_output_filter(
    *, filtered_prefixes: Iterable[str] | None = None, filtered_patterns: Iterable[str] | None = None
) -> Callable[[str], str]:
    """Make a function that leaves out lines.

    :param filtered_prefixes: beginnings of lines to leave out; None: the usual ones.
    :param filtered_patterns: regular expressions of lines to leave out; None: the usual ones.
    """
    prefixes = tuple(get_default_filtered_prefixes() if filtered_prefixes is None else filtered_prefixes)
    patterns = [
        re.compile(pattern) for pattern in (get_default_filtered_patterns() if filtered_patterns is None else filtered_patterns)
    ]

    def filtered(output: str) -> str:
        return ''.join(
            line
            for line in output.splitlines(keepends=True)
            if not line.startswith(prefixes) and not any(pattern.match(line) for pattern in patterns)
        )

    return filtered


def expected_output_from_file(path: str | os.PathLike[str]) -> list[str | re.Pattern[str]]:
    """What a program should write, a line each: texts from `<path>.txt`, or regular expressions from `<path>.regex`.

    :param path: with or without that ending.
    :raises RuntimeError: when there is no such file.
    """
    base, ending = os.path.splitext(os.fspath(path))
    if ending not in _LINES_OF:
        base = os.fspath(path)
    for name in [base + ending] if ending in _LINES_OF else [base + known for known in _LINES_OF]:
        if os.path.isfile(name):
            with open(name, encoding='utf-8') as file:
                return [_LINES_OF[os.path.splitext(name)[1]](line) for line in file.read().splitlines()]
    raise RuntimeError(f'could not find output check file: {os.fspath(path)}\n  help: it may end with {" or ".join(_LINES_OF)}')


def _text(line: str) -> str | re.Pattern[str]:
    return line


def _pattern(line: str) -> str | re.Pattern[str]:
    return re.compile(line)


_LINES_OF: dict[str, Callable[[str], str | re.Pattern[str]]] = {'.txt': _text, '.regex': _pattern}
