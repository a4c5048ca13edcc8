"""Reads one ROS argument, such as `from:=to` or `name:=value`: its lexemes, and the error messages of rcl."""

from __future__ import annotations

import re

_LEXEMES = (
    ('~/', 2),
    ('rosservice://', 3),
    ('rostopic://', 4),
    (':=', 8),
    (':', 5),
    ('__node', 6),
    ('__name', 6),
    ('__ns', 7),
    ('**', 21),
    ('*', 20),
    ('/', 19),
    ('.', 22),
)
_TOKEN = re.compile(r'(?:[a-zA-Z]|_(?!_))(?:_?[a-zA-Z0-9])*_?')
_BACK_REFERENCE = re.compile(r'\\[1-9]')

NOTHING, END, TILDE_SLASH, SERVICE_SCHEME, TOPIC_SCHEME, COLON, NODE, NAMESPACE, SEPARATOR, BACK_REFERENCE = range(10)
TOKEN, SLASH, WILD_ONE, WILD_ANY, DOT = range(18, 23)


class RuleError(Exception):
    """An argument that rcl rejects. The message is the part of rcl's message after `Error:`."""


class RuleReader:
    """A reader that splits an argument into lexemes. The kinds of lexemes have rcl's numbers, because rcl's messages show
    them.
    """

    def __init__(self, text: str, position: int = 0) -> None:
        self.text = text
        self.position = position
        self.kind, self._end = self._lexeme_at(position)

    def _lexeme_at(self, start: int) -> tuple[int, int]:
        """Return the kind of the lexeme that begins at `start`, and the position of its end."""
        if start == len(self.text):
            return END, start
        for words, kind in _LEXEMES:
            if self.text.startswith(words, start):
                return kind, start + len(words)
        for pattern, kind in ((_TOKEN, TOKEN), (_BACK_REFERENCE, BACK_REFERENCE)):
            found = pattern.match(self.text, start)
            if found:
                return kind + (int(found[0][1]) - 1 if kind == BACK_REFERENCE else 0), found.end()
        return NOTHING, start

    def take(self) -> str:
        """Move past the next lexeme, and return its string."""
        taken = self.text[self.position : self._end]
        self.position = self._end
        self.kind, self._end = self._lexeme_at(self.position)
        return taken

    def expect(self, kind: int) -> str:
        """Move past the next lexeme, which must be of the given kind, and return its string.

        :raises RuleError: if the lexeme is of another kind.
        """
        if self.kind != kind:
            if self.kind in (NOTHING, END):
                raise RuleError(f'Expected lexeme type ({kind}) not found, search ended at index {self.position}')
            raise RuleError(f'Expected lexeme type {kind}, got {self.kind} at index {self.position}')
        return self.take()

    def node_prefix(self) -> str | None:
        """Move past `name:` at the beginning, and return the name. Return None if there is no such prefix."""
        if self.kind != TOKEN or self._lexeme_at(self._end)[0] != COLON:
            return None
        name = self.take()
        self.take()
        return name

    def expect_name_token(self) -> None:
        """Move past a token of a name to match.

        :raises RuleError: if the next lexeme is a wildcard, or not a token.
        """
        if self.kind in (WILD_ONE, WILD_ANY):
            raise RuleError(f"Wildcard '{self.take()}' is not implemented")
        if self.kind != TOKEN:
            raise RuleError('Expecting token or wildcard')
        self.take()

    def expect_new_token(self) -> None:
        """Move past a token of a new name.

        :raises RuleError: if the next lexeme is not a token. The message contains no reason, like rcl's message.
        """
        if BACK_REFERENCE <= self.kind < TOKEN:
            raise RuleError('Backreferences are not implemented')
        if self.kind != TOKEN:
            raise RuleError('error not set')
        self.take()


def read_parameter_name(reader: RuleReader) -> str:
    """Move past a parameter name and the `:=` after it, and return the name. Slashes are allowed anywhere in the name.

    :raises RuleError: if the name is invalid.
    """
    start = reader.position
    while True:
        if reader.kind not in (TOKEN, SLASH):
            reader.expect_name_token()
        while reader.kind in (TOKEN, SLASH):
            reader.take()
        if reader.kind == SEPARATOR:
            name = reader.text[start : reader.position]
            reader.take()
            return name
        reader.expect(DOT)


def read_matched_name(reader: RuleReader) -> str:
    """Move past a topic or service name and the `:=` after it, and return the name.

    :raises RuleError: if the name is invalid.
    """
    start = reader.position
    if reader.kind in (TILDE_SLASH, SLASH):
        reader.take()
    reader.expect_name_token()
    while reader.kind != SEPARATOR:
        reader.expect(SLASH)
        reader.expect_name_token()
    name = reader.text[start : reader.position]
    reader.take()
    return name


def read_new_name(reader: RuleReader) -> str:
    """Return the topic or service name to the right of `:=`, which is the rest of the argument.

    :raises RuleError: if the name is invalid.
    """
    start = reader.position
    if reader.kind in (TILDE_SLASH, SLASH):
        reader.take()
    reader.expect_new_token()
    while reader.kind != END:
        reader.expect(SLASH)
        reader.expect_new_token()
    return reader.text[start:]


def read_new_namespace(reader: RuleReader) -> str:
    """Return the absolute namespace to the right of `:=`, which is the rest of the argument.

    :raises RuleError: if the namespace is invalid.
    """
    start = reader.position
    reader.expect(SLASH)
    while reader.kind == TOKEN:
        reader.take()
        if reader.kind == SLASH:
            reader.take()
    reader.expect(END)
    return reader.text[start:]
