"""The content of a file with offsets, lines and columns, and the spans of the parts of a Python file."""

from __future__ import annotations

import ast
import re
from bisect import bisect_right
from functools import cached_property
from typing import Any, NamedTuple

LONGEST = 400_000
"""The maximum number of characters of a file that is checked. Files written by hand are shorter."""


class Span(NamedTuple):
    """A part of a file: the offset of its first character, and the offset after its last character."""

    start: int
    end: int


class Place(NamedTuple):
    """A place in a file. Lines count from 1, and columns count characters from 0."""

    line: int
    column: int


class Text:
    """The content of a file or of an editor.

    :ivar path: the path of the file, which may not exist yet.
    """

    def __init__(self, text: str, path: str) -> None:
        self.text = text
        self.path = path
        self._starts = [0, *(found.end() for found in re.finditer('\n', text))]

    @cached_property
    def tree(self) -> ast.Module | None:
        """The syntax tree of a Python file, or None if Python cannot parse it."""
        try:
            return ast.parse(self.text, self.path)
        except (SyntaxError, ValueError, RecursionError):
            return None

    def place(self, offset: int) -> Place:
        """Return the line and column of an offset."""
        number = bisect_right(self._starts, offset)
        return Place(number, offset - self._starts[number - 1])

    def offset(self, line: int, column: int) -> int:
        """Return the offset of a line and column. A place outside the file is moved to the nearest end of a line."""
        number = min(max(line, 1), len(self._starts))
        return min(self._starts[number - 1] + max(column, 0), self.whole_line(number).end)

    def whole_line(self, line: int) -> Span:
        """Return the span of a line without its line break."""
        number = min(max(line, 1), len(self._starts))
        start = self._starts[number - 1]
        end = self.text.find('\n', start)
        return Span(start, len(self.text) if end < 0 else end)

    def line_span(self, line: int) -> Span:
        """Return the span of a line without its indentation and the spaces at its end."""
        start, end = self.whole_line(line)
        words = self.text[start:end]
        return Span(start + len(words) - len(words.lstrip()), start + len(words.rstrip())) if words.strip() else Span(start, end)

    def _byte_offset(self, line: int, column: int) -> int:
        """Return the offset of a place in a syntax tree, whose columns count bytes."""
        start, end = self.whole_line(line)
        words = self.text[start:end]
        return start + (column if words.isascii() else len(words.encode()[:column].decode(errors='ignore')))

    def of_node(self, node: Any) -> Span:
        """Return the span of a node of the syntax tree."""
        return Span(self._byte_offset(node.lineno, node.col_offset), self._byte_offset(node.end_lineno, node.end_col_offset))

    def found(self, words: str, within: Span) -> Span | None:
        """Return the span of a string in a part of the file. Return None if the string does not occur there exactly once.

        :param words: the string to find.
        :param within: the part of the file to search.
        """
        before = r'(?<!\w)' if words[:1].isidentifier() else ''
        behind = r'(?!\w)' if words[-1:].isidentifier() or words[-1:].isdigit() else ''
        spans = [
            Span(*one.span())
            for one in re.compile(before + re.escape(words) + behind).finditer(self.text, within.start, within.end)
        ]
        return spans[0] if len(spans) == 1 else None

    def extent(self, line: int) -> Span:
        """Return the span of the code that begins in a line: a call or statement in Python, a tag in XML, or otherwise the
        line.
        """
        own = self.line_span(line)
        if self.path.endswith('.py') and self.tree is not None:
            nodes: list[Any] = [
                node
                for node in ast.walk(self.tree)
                if isinstance(node, (ast.Call, ast.stmt))
                and node.lineno == line
                and not isinstance(node, (ast.FunctionDef, ast.ClassDef, ast.If, ast.For, ast.While, ast.With, ast.Try))
            ]
            ends = [self.of_node(node).end for node in nodes]
            return Span(own.start, max([own.end, *ends]))
        if self.text[own.start : own.start + 1] == '<':
            end = self.text.find('>', own.start)
            return Span(own.start, max(own.end, end + 1))
        return own
