"""Converts the string of an attribute to substitutions."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Any, NamedTuple

from edulaunch.engine.facts import with_facts
from edulaunch.engine.nearest import nearest

from ..substitution import Substitution
from ..substitutions.text_substitution import TextSubstitution
from .expose import ParseMethod, substitution_parse_methods
from .extensions import load_launch_extensions
from .substitution_parsers import LateSubstitution

MAX_DEPTH = 50
"""The maximum depth of nested `$(...)`."""


class Call(NamedTuple):
    """One substitution of the form `$(name argument...)`."""

    name: str
    arguments: tuple[Template, ...]


Template = tuple[str | Call, ...]

_NAME = re.compile(r'[A-Za-z][A-Za-z0-9_-]*')
_OUTSIDE = re.compile(r'(?:[^\\$]+|\$(?!\())+')
_BARE = {'': re.compile(r'[^ \'"\\$()]+'), "'": re.compile(r"[^ '\\$()]+"), '"': re.compile(r'[^ "\\$()]+')}
"""Patterns of unquoted text, by the quotation marks around the call."""
_QUOTED = {"'": re.compile(r"(?:[^\\$']+|\$(?!\())+"), '"': re.compile(r'(?:[^\\$"]+|\$(?!\())+')}


@lru_cache(maxsize=4096)
def parse_template(text: str) -> Template:
    """Return the parts of a string, in order. Equal strings share one immutable result.

    :raises UnexpectedCharacters: for a character that the grammar does not allow.
    :raises UnexpectedEOF: when a `$(` or a quote in it is not closed.
    """
    reader = _Reader(text)
    pieces = reader.pieces(_OUTSIDE)
    if reader.position < len(text):
        raise UnexpectedCharacters(text, reader.position, 'a character after the backslash')
    return pieces


class _Reader:
    """A recursive-descent parser of one string."""

    __slots__ = ('text', 'position', 'depth', 'quote')

    def __init__(self, text: str) -> None:
        self.text = text
        self.position = 0
        self.depth = 0
        self.quote = ''

    def pieces(self, literal: re.Pattern[str]) -> Template:
        """Return calls, escapes and runs of `literal`, up to the first other character."""
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
        """Return one `$(...)`, starting at its dollar sign."""
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
        """Return one argument, with or without quotes."""
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
        """Return the error for an unexpected character, or for the unexpected end of the string, at the position."""
        if self.position >= len(self.text):
            return UnexpectedEOF(self.text, self.position, expected)
        return UnexpectedCharacters(self.text, self.position, expected)


CONTEXT_WIDTH = 40
LONGEST_SHOWN = 60


class SubstitutionSyntaxError(Exception):
    """The base class of syntax errors in a `$(...)`."""


class UnexpectedInput(SubstitutionSyntaxError):
    """The string does not follow the grammar.

    :param position: index of the offending character.
    :param expected: a description of the allowed characters.
    :ivar line: line of that character within the string, from 1.
    :ivar column: column of that character, from 1.
    """

    def __init__(self, text: str, position: int, expected: str) -> None:
        self.pos_in_stream = position
        self.line = text.count('\n', 0, position) + 1
        self.column = position - text.rfind('\n', 0, position)
        shown = text if len(text) <= LONGEST_SHOWN else f'{text[:LONGEST_SHOWN]}...'
        with_facts(self, 'launch.call-syntax', expected_there=expected, column=self.column, text=shown)
        super().__init__(f'{self.first_line(text)}Expected one of: \n\t* {expected}\n')

    def first_line(self, text: str) -> str:
        """Return the part of lark's message before the list of expected tokens."""
        return 'Unexpected input. '


class UnexpectedCharacters(UnexpectedInput):
    """The grammar does not allow a character at its position. The message marks the character with a caret."""

    def first_line(self, text: str) -> str:
        """Return the first line of the message: the unexpected character and its place."""
        found = text[self.pos_in_stream]
        place = f'at line {self.line} col {self.column}'
        return f"No terminal matches '{found}' in the current parser context, {place}\n\n{_pointing_at(text, self.pos_in_stream)}"


class UnexpectedEOF(UnexpectedInput):
    """The string ends inside a `$(...)`."""

    def first_line(self, text: str) -> str:
        """Return an empty string, because the message has no such line."""
        return 'Unexpected end-of-input. '


class VisitError(SubstitutionSyntaxError):
    """A `$(...)` is well-formed, but its name is unknown or it has the wrong number of arguments.

    :ivar rule: the grammar rule, 'substitution'.
    :ivar orig_exc: the original error, which is also the `__cause__`.
    """

    def __init__(self, rule: str, error: Exception) -> None:
        super().__init__(f'Error trying to process rule "{rule}":\n\n{error}')
        self.rule = rule
        self.orig_exc = error


def _pointing_at(text: str, position: int) -> str:
    before = text[max(position - CONTEXT_WIDTH, 0) : position].rsplit('\n', 1)[-1]
    after = text[position : position + CONTEXT_WIDTH].split('\n', 1)[0]
    return f'{before}{after}\n{" " * len(before.expandtabs())}^\n'


_ESCAPE = re.compile(r'\\(.)', re.DOTALL)


def parse_substitution(string: str) -> list[Substitution]:
    """Return the substitutions in a string such as `a$(var b)c`. Literal parts become TextSubstitution objects.

    Built-in substitutions never change, so equal strings share them. Substitutions of extensions are created each time.

    :raises SubstitutionSyntaxError: when the string is invalid; see the subclasses. The facts of the error contain what was
        expected.
    """
    if '$(' not in string and '\\' not in string:
        return [_literal(string)]
    template = parse_template(string)
    return list(_shared(template) if _is_built_in(template) else _built(template))


def parse_if_substitutions(value: Any) -> Any:
    """Parse a string that contains `$(...)` with :func:`parse_substitution`. Any other string remains a string without its
    backslashes.

    Other scalars are returned unchanged, and each item of a list is parsed.

    :raises ValueError: when the items of a list, except those with substitutions, have different types.
    """
    if isinstance(value, str):
        if '$(' not in value and '\\' not in value:
            return value
        parsed = parse_substitution(value)
        if len(parsed) == 1 and isinstance(parsed[0], TextSubstitution):
            return parsed[0].text
        return parsed
    if isinstance(value, list):
        items = [parse_if_substitutions(item) for item in value]
        if len({type(item) for item in items if not isinstance(item, list)}) > 1:
            raise ValueError(f'the items of a list must be of one type, got {value}')
        return items
    return value


def replace_escaped_characters(data: str) -> str:
    """Remove each backslash, but keep the character after it."""
    return _ESCAPE.sub(r'\1', data) if '\\' in data else data


@lru_cache(maxsize=4096)
def _literal(text: str) -> TextSubstitution:
    return TextSubstitution(text=text)


def _built(template: Template) -> tuple[Substitution, ...]:
    # An empty string is a value, too.
    return tuple([_piece(piece) for piece in template]) or (_literal(''),)


_shared = lru_cache(maxsize=4096)(_built)


@lru_cache(maxsize=4096)
def _is_built_in(template: Template) -> bool:
    """Return whether all calls are calls of built-in substitutions. No other code can take their names."""
    return all(
        isinstance(substitution_parse_methods.get(piece.name), LateSubstitution) and all(map(_is_built_in, piece.arguments))
        for piece in template
        if isinstance(piece, Call)
    )


def _piece(piece: str | Call) -> Substitution:
    if isinstance(piece, str):
        return _literal(piece)
    name, arguments = piece
    made = [[_piece(part) for part in argument] for argument in arguments]
    try:
        made_by, kwargs = (substitution_parse_methods.get(name) or _parse_method_of_extension(name))(made)
        substitution: Substitution = made_by(**kwargs)
    except Exception as error:
        # Upstream uses lark, which shows only the outer error.
        near = nearest(name, substitution_parse_methods)
        known = name in substitution_parse_methods
        raise with_facts(VisitError('substitution', error), 'launch.call', call=name, near=near, is_known=known) from error
    return substitution


def _parse_method_of_extension(name: str) -> ParseMethod:
    _load_extensions_once()
    parse = substitution_parse_methods.get(name)
    if parse is None:
        raise RuntimeError(f'Unknown substitution: {name}')
    return parse


@lru_cache(maxsize=1)
def _load_extensions_once() -> None:
    load_launch_extensions()
