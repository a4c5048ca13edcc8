"""Filters of output."""
from __future__ import annotations

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


def basic_output_filter(*, filtered_prefixes: Iterable[str] | None = None,
                        filtered_patterns: Iterable[str] | None = None) -> Callable[[str], str]:
    """Make a function that leaves out lines.

    :param filtered_prefixes: beginnings of lines to leave out; None: the usual ones.
    :param filtered_patterns: regular expressions of lines to leave out; None: the usual ones.
    """
    prefixes = tuple(get_default_filtered_prefixes() if filtered_prefixes is None else filtered_prefixes)
    patterns = [re.compile(pattern) for pattern in
                (get_default_filtered_patterns() if filtered_patterns is None else filtered_patterns)]

    def filtered(output: str) -> str:
        return ''.join(line for line in output.splitlines(keepends=True)
                       if not line.startswith(prefixes) and not any(pattern.match(line) for pattern in patterns))
    return filtered
