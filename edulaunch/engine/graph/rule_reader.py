"""Read one argument for ROS, as `from:=to` or `name:=value`: tokens, and rcl's error messages."""

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
    """An argument that rcl rejects. The message is rcl's message after `Error:`."""


class RuleReader:
    """Reads an argument lexeme by lexeme. The numbers of the lexemes are those of rcl, because its messages show them."""

    def __init__(self, text: str, position: int = 0) -> None:
        self.text = text
        self.position = position
        self.kind, self._end = self._lexeme_at(position)

    def _lexeme_at(self, start: int) -> tuple[int, int]:
        """Return the lexeme that begins there, and where it ends."""
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
        """Move past the next lexeme, and return it."""
        taken = self.text[self.position : self._end]
        self.position = self._end
        self.kind, self._end = self._lexeme_at(self.position)
        return taken

    def expect(self, kind: int) -> str:
        """Move past the next lexeme, which must be of that kind, and return it.

        :raises RuleError: when it is of another kind.
        """
        if self.kind != kind:
            if self.kind in (NOTHING, END):
                raise RuleError(f'Expected lexeme type ({kind}) not found, search ended at index {self.position}')
            raise RuleError(f'Expected lexeme type {kind}, got {self.kind} at index {self.position}')
        return self.take()

    def node_prefix(self) -> str | None:
        """Return the name before a single colon at the beginning, or None."""
        if self.kind != TOKEN or self._lexeme_at(self._end)[0] != COLON:
            return None
        name = self.take()
        self.take()
        return name

    def expect_name_token(self) -> None:
        """Move past a token of a name to match. Raise RuleError for a wildcard, or anything else."""
        if self.kind in (WILD_ONE, WILD_ANY):
            raise RuleError(f"Wildcard '{self.take()}' is not implemented")
        if self.kind != TOKEN:
            raise RuleError('Expecting token or wildcard')
        self.take()

    def expect_new_token(self) -> None:
        """Move past a token of a new name. Raise RuleError without one, and without a reason, as rcl does."""
        if BACK_REFERENCE <= self.kind < TOKEN:
            raise RuleError('Backreferences are not implemented')
        if self.kind != TOKEN:
            raise RuleError('error not set')
        self.take()


def read_parameter_name(reader: RuleReader) -> str:
    """Read the parameter's name up to `:=`, and move past it. Slashes are allowed anywhere in it.

    :raises RuleError: when it breaks the rules.
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

    :raises RuleError: when it breaks the rules.
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
    """Return the topic or service name to the right of `:=`, up to the end.

    :raises RuleError: when it breaks the rules.
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
    """Return the absolute namespace to the right of `:=`, up to the end.

    :raises RuleError: when it breaks the rules.
    """
    start = reader.position
    reader.expect(SLASH)
    while reader.kind == TOKEN:
        reader.take()
        if reader.kind == SLASH:
            reader.take()
    reader.expect(END)
    return reader.text[start:]
