"""Find syntax errors of Python with their places, and edits after which Python can parse the file."""

from __future__ import annotations

import ast
import io
import tokenize
from collections.abc import Iterator
from typing import NamedTuple

from edulaunch.advice.errors.python_syntax import QUOTES, STRAIGHT
from edulaunch.advice.rule import Failure
from edulaunch.advice.texts.edits import Edit, Edits, applied, inserted
from edulaunch.advice.texts.text import Span, Text


class Foreseen(NamedTuple):
    """A predicted error, and the place of its cause.

    :ivar span: the place of the cause, or None if only the line of the failure is known.
    :ivar edits: the certain edits, or None for the edits of the rule.
    """

    failure: Failure
    span: Span | None = None
    edits: Edits | None = None


def syntax_error(text: Text) -> Foreseen | None:
    """Return the first syntax error, or None if Python can parse the file."""
    try:
        ast.parse(text.text, text.path)
    except SyntaxError as error:
        line, column = error.lineno or 1, max((error.offset or 1) - 1, 0)
        start = text.offset(line, column)
        end = text.offset(error.end_lineno or line, max((error.end_offset or 0) - 1, 0))
        failure = Failure(type(error).__name__, error.msg, text.path, line)
        is_odd = text.text[start : start + 1] in (*QUOTES, *STRAIGHT)
        span = Span(start, end) if end > start else Span(start, start + 1) if is_odd else text.line_span(line)
        return Foreseen(failure, span, _certain(text, error, span))
    except (ValueError, RecursionError, MemoryError) as error:
        return Foreseen(Failure(type(error).__name__, str(error), text.path, 1))
    return None


def _certain(text: Text, error: SyntaxError, span: Span) -> Edits:
    """Return the first possible edits after which Python can parse more of the file, or no edits."""
    line = error.lineno or 1
    for edits in _tries(text, error.msg, line, span):
        if _reads(text.text, edits, line):
            return edits
    return ()


def _tries(text: Text, message: str, line: int, span: Span) -> Iterator[Edits]:
    if 'forgot a comma' in message or 'invalid syntax' in message:
        yield from ((inserted(text, offset, ','),) for offset in _gaps(text, span))
    if "expected ':'" in message:
        yield (inserted(text, _end_of_code(text, line), ':'),)
    if 'invalid character' in message or 'invalid non-printable' in message:
        start, end = text.whole_line(line)
        odd = [
            (offset, text.text[offset])
            for offset in range(start, end)
            if text.text[offset] in QUOTES or text.text[offset] in STRAIGHT
        ]
        for quote in '\'"':
            yield tuple(
                Edit(
                    text.path,
                    Span(offset, offset + 1),
                    one,
                    quote if one in QUOTES else STRAIGHT[one].replace('an ordinary space', ' '),
                )
                for offset, one in odd
            )
    if "Maybe you meant '=='" in message:
        at = text.found('=', span)
        if at is not None:
            yield (Edit(text.path, at, '=', '=='),)


def _reads(text: str, edits: Edits, line: int) -> bool:
    """Return whether Python can parse the edited file beyond this line."""
    try:
        ast.parse(applied(text, edits))
    except SyntaxError as error:
        return (error.lineno or 0) > line + 1
    except (ValueError, RecursionError, MemoryError):
        return False
    return True


def _gaps(text: Text, span: Span) -> Iterator[int]:
    """Yield the offset after each word or closing bracket in a span, beginning at the start of its first line."""
    start = text.whole_line(text.place(span.start).line)
    part = text.text[start.start : max(span.end, text.whole_line(text.place(span.end).line).end)]
    try:
        tokens = list(tokenize.generate_tokens(io.StringIO(part).readline))
    except (tokenize.TokenError, SyntaxError):
        tokens = []
        reader = tokenize.generate_tokens(io.StringIO(part).readline)
        try:
            for token in reader:
                tokens.append(token)
        except (tokenize.TokenError, SyntaxError):
            pass
    inner = Text(part, text.path)
    for one, other in zip(tokens, tokens[1:], strict=False):
        is_end = one.type in (tokenize.NAME, tokenize.NUMBER, tokenize.STRING) or one.string in (')', ']', '}')
        offset = start.start + inner.offset(*one.end)
        if is_end and offset >= span.start and other.string not in (',', ':', ')', ']', '}'):
            yield offset


def _end_of_code(text: Text, line: int) -> int:
    """Return the offset of the end of the code in a line, before a comment."""
    start, end = text.line_span(line)
    before = text.text[start:end].partition('#')[0].rstrip()
    return start + len(before)
