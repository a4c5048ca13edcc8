r"""The grammar of `$(...)`: from a text to literal pieces and calls.

::

    text       = (call | literal)*                 $ without ( is literal; \ takes the next character as it is
    call       = '$(' name (' ' argument)* ')'     name: LETTER (LETTER | DIGIT | _ | -)*
    argument   = (call | bare)+ | "'" quoted* "'" | '"' quoted* '"'
    bare       = no space ' " \ $ ( )              quoted: anything but its own quote

Exactly one space stands before an argument and none before the closing parenthesis, as upstream. The arguments of a call
inside quotes are always bare; there the other kind of quote is a character like any other: in "$(env 'a')" the name is 'a' with
its quotes.
"""

from __future__ import annotations

import re
from functools import lru_cache
from typing import NamedTuple

from .substitution_errors import SubstitutionSyntaxError, UnexpectedCharacters, UnexpectedEOF

MAX_DEPTH = 50
"""How deep `$(...)` may stand inside each other."""


class Call(NamedTuple):
    """One `$(name argument...)`."""

    name: str
    arguments: tuple[Template, ...]


Template = tuple[str | Call, ...]

_NAME = re.compile(r'[A-Za-z][A-Za-z0-9_-]*')
_OUTSIDE = re.compile(r'(?:[^\\$]+|\$(?!\())+')
_BARE = {'': re.compile(r'[^ \'"\\$()]+'), "'": re.compile(r"[^ '\\$()]+"), '"': re.compile(r'[^ "\\$()]+')}
"""By the quotes around the call."""
_QUOTED = {"'": re.compile(r"(?:[^\\$']+|\$(?!\())+"), '"': re.compile(r'(?:[^\\$"]+|\$(?!\())+')}


@lru_cache(maxsize=4096)
def parse_template(text: str) -> Template:
    """The pieces of a text, in order; equal texts share one (immutable) result.

    :raises UnexpectedCharacters: for a character that the grammar does not allow.
    :raises UnexpectedEOF: when a `$(` or a quote in it is not closed.
    """
    reader = _Reader(text)
    pieces = reader.pieces(_OUTSIDE)
    if reader.position < len(text):
        raise UnexpectedCharacters(text, reader.position, 'a character after the backslash')
    return pieces


class _Reader:
    """A recursive-descent parser over one text."""

    __slots__ = ('text', 'position', 'depth', 'quote')

    def __init__(self, text: str) -> None:
        self.text = text
        self.position = 0
        self.depth = 0
        self.quote = ''

    def pieces(self, literal: re.Pattern[str]) -> Template:
        """Calls, escapes and runs of `literal`, up to the first character that is neither."""
        text = self.text
        pieces: list[str | Call] = []
        run: list[str] = []
        while True:
            match = literal.match(text, self.position)
            if match:
                run.append(match.group())
                self.position = match.end()
            elif text.startswith('$(', self.position):
                if run:
                    pieces.append(''.join(run))
                    run = []
                pieces.append(self.call())
            elif text.startswith('\\', self.position) and self.position + 1 < len(text):
                run.append(text[self.position + 1])
                self.position += 2
            else:
                break
        if run:
            pieces.append(''.join(run))
        return tuple(pieces)

    def call(self) -> Call:
        """One `$(...)`, starting at its dollar sign."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise SubstitutionSyntaxError(f'more than {MAX_DEPTH} substitutions stand inside each other')
        self.position += 2
        name = _NAME.match(self.text, self.position)
        if name is None:
            raise self.unexpected('the name of a substitution, such as var')
        self.position = name.end()
        arguments = []
        while self.text.startswith(' ', self.position):
            self.position += 1
            arguments.append(self.argument())
        if not self.text.startswith(')', self.position):
            raise self.unexpected("one space and an argument, or ')'")
        self.position += 1
        self.depth -= 1
        return Call(name.group(), tuple(arguments))

    def argument(self) -> Template:
        """One argument, bare or in quotes."""
        quote = self.text[self.position : self.position + 1]
        if self.quote or quote not in ("'", '"'):
            pieces = self.pieces(_BARE[self.quote])
            if not pieces:
                raise self.unexpected('an argument (after exactly one space)')
            return pieces
        self.position += 1
        self.quote = quote
        pieces = self.pieces(_QUOTED[quote])
        self.quote = ''
        if not self.text.startswith(quote, self.position):
            raise self.unexpected(f'the closing quote {quote}')
        self.position += 1
        return pieces

    def unexpected(self, expected: str) -> SubstitutionSyntaxError:
        """The error for what stands (or does not stand) at the position."""
        if self.position >= len(self.text):
            return UnexpectedEOF(self.text, self.position, expected)
        return UnexpectedCharacters(self.text, self.position, expected)
