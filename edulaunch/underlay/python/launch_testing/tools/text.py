"""Comparing texts."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import Any

from osrf_pycommon.terminal_color import remove_ansi_escape_sequences

Match = Callable[..., 'tuple[int, int] | None']


def build_text_match(expected_text: Any, *, strip_ansi_escape_sequences: bool = True) -> Match:
    """Make a function (text, start=0) that gives where the expected text begins and ends, or None.

    :param expected_text: a text, a compiled regular expression, or a list of them: each is looked for behind the one
        before it.
    :raises ValueError: for anything else.
    """
    one_by_one = [_matcher(item) for item in _as_list(expected_text)]

    def match(actual_text: str, start: int = 0) -> tuple[int, int] | None:
        text = remove_ansi_escape_sequences(actual_text) if strip_ansi_escape_sequences else actual_text
        first, end = None, start
        for matcher in one_by_one:
            found = matcher(text, end)
            if found is None:
                return None
            first = found[0] if first is None else first
            end = found[1]
        return (start if first is None else first), end

    return match


def _as_list(expected: Any) -> list[Any]:
    return [expected] if isinstance(expected, (str, re.Pattern)) or not isinstance(expected, Iterable) else list(expected)


def _matcher(expected: Any) -> Callable[[str, int], tuple[int, int] | None]:
    if isinstance(expected, str):

        def find(text: str, start: int) -> tuple[int, int] | None:
            position = text.find(expected, start)
            return None if position < 0 else (position, position + len(expected))

        return find
    if isinstance(expected, re.Pattern):

        def search(text: str, start: int) -> tuple[int, int] | None:
            found = expected.search(text, start)
            return None if found is None else found.span()

        return search
    raise ValueError(
        'Unknown format for expected text: expected a text or a compiled regular expression, '
        f'got {type(expected).__name__}: {expected!r}'
    )


def expect_output(
    *,
    expected_text: Any = None,
    expected_lines: Iterable[Any] | None = None,
    text: str | None = None,
    lines: Iterable[str] | None = None,
    strict: bool = False,
) -> bool:
    """Whether the output is what was expected.

    :param expected_text: a text or compiled regular expression; or
    :param expected_lines: one for each line, in order.
    :param text: the output; or
    :param lines: its lines.
    :param strict: nothing else may be there.
    :raises ValueError: unless exactly one expectation and exactly one output are given.
    """
    if (expected_text is None) == (expected_lines is None):
        raise ValueError("Either 'expected_text' or 'expected_lines' must be given, and not both")
    if (text is None) == (lines is None):
        raise ValueError("Either 'text' or 'lines' must be given, and not both")
    if expected_text is not None:
        return _text_matches(expected_text, '\n'.join(lines) if text is None else text, strict)  # type: ignore[arg-type]
    actual = (text or '').splitlines() if lines is None else [line.rstrip('\n') for line in lines]
    return _lines_match(list(expected_lines or ()), actual, strict)


def _text_matches(expected: Any, text: str, strict: bool) -> bool:
    found = _matcher(expected)(text, 0)
    return found is not None and (not strict or found == (0, len(text)))


def _lines_match(expected: list[Any], actual: list[str], strict: bool) -> bool:
    if strict:
        return len(expected) == len(actual) and all(
            _text_matches(pattern, line, True) for pattern, line in zip(expected, actual, strict=True)
        )
    rest = iter(actual)
    return all(any(_text_matches(pattern, line, False) for line in rest) for pattern in expected)
