"""Functions that find expected strings in output."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import Any

from osrf_pycommon.terminal_color import remove_ansi_escape_sequences

Match = Callable[..., 'tuple[int, int] | None']


def build_text_match(expected_text: Any, *, strip_ansi_escape_sequences: bool = True) -> Match:
    """Return a function (text, start=0) that returns the start and end of the expected string, or None if the text does not
    contain it.

    :param expected_text: a string, a compiled regular expression, or a list of them. Each item must come after the previous
        item.
    :raises ValueError: for anything else.
    """
    one_by_one = [_matcher(item) for item in _as_list(expected_text)]

    def match(actual_text: str, start: int = 0) -> tuple[int, int] | None:
        text = remove_ansi_escape_sequences(actual_text) if strip_ansi_escape_sequences else actual_text
        spans, end = [], start
        for matcher in one_by_one:
            found = matcher(text, end)
            if found is None:
                return None
            spans.append(found)
            end = found[1]
        return (spans[0][0] if spans else start), end

    return match


def _as_list(expected: Any) -> list[Any]:
    return [expected] if isinstance(expected, (str, re.Pattern)) or not isinstance(expected, Iterable) else list(expected)


def _matcher(expected: Any) -> Callable[[str, int], tuple[int, int] | None]:
    if isinstance(expected, str):
        expected = re.compile(re.escape(expected))
    elif not isinstance(expected, re.Pattern):
        raise ValueError(
            'Unknown format for expected text: expected a text or a compiled regular expression, '
            f'got {type(expected).__name__}: {expected!r}'
        )

    def search(text: str, start: int) -> tuple[int, int] | None:
        found = expected.search(text, start)
        return None if found is None else found.span()

    return search
