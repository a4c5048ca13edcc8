"""What the words of a shell line stand for: variables, what other lines write, patterns."""

from __future__ import annotations

import glob
import os
from collections.abc import Callable, Iterable, Mapping, Sequence

from edulaunch.processes.shell_grammar import Command, Line, Piece, Word

_PATTERN_SIGNS = '*?['


class Expansion:
    """Makes plain words.

    :param variables: by name.
    :param arguments: `$0`, `$1` and so on.
    :param written: gives what a line in `$(...)` writes.
    """

    def __init__(
        self, variables: Mapping[str, str], arguments: Sequence[str], cwd: str | None, written: Callable[[Line], str]
    ) -> None:
        self._variables = variables
        self._arguments = arguments
        self._cwd = cwd
        self._written = written

    def words(self, words: Iterable[Word]) -> list[str]:
        """Each word, which may become several, or none."""
        return [found for word in words for found in self.fields(word)]

    def one(self, word: Word) -> str:
        """A word that stays one: the name of a file, or a value."""
        return ''.join(self._text(word, piece) if piece.kind == 'text' else self._value(piece) for piece in word)

    def fields(self, word: Word) -> list[str]:
        """The words that a word becomes."""
        fields: list[tuple[str, str]] = []
        text = pattern = ''
        is_there = False
        for piece in word:
            parts, is_open = self._parts(word, piece)
            for number, part in enumerate(parts):
                if number:
                    fields.append((text, pattern))
                    text = pattern = ''
                text += part
                pattern += part if is_open else glob.escape(part)
            is_there = is_there or bool(parts)
        if is_there:
            fields.append((text, pattern))
        return [found for field in fields for found in self._matches(*field)]

    def _parts(self, word: Word, piece: Piece) -> tuple[list[str], bool]:
        """The words that begin with this piece (the first goes on with what is there), and whether it may be a pattern."""
        if piece.kind == 'text':
            return [self._text(word, piece)], not piece.is_quoted
        if piece.is_quoted and piece.text == '@':
            return list(self._arguments[1:]), False
        value = self._value(piece)
        return ([value] if piece.is_quoted else value.split()), not piece.is_quoted

    def _text(self, word: Word, piece: Piece) -> str:
        home = piece is word[0] and piece.text == '~' and not piece.is_quoted and (len(word) == 1 or word[1].text[:1] == '/')
        return self._variables.get('HOME', '~') if home else piece.text

    def _value(self, piece: Piece) -> str:
        if piece.kind == 'line':
            return self._written(piece.line).rstrip('\n')
        if piece.text in '@*':
            return ' '.join(self._arguments[1:])
        if piece.text.isdigit():
            return self._arguments[int(piece.text)] if int(piece.text) < len(self._arguments) else piece.default
        return self._variables.get(piece.text) or piece.default

    def _matches(self, text: str, pattern: str) -> list[str]:
        if not any(sign in text for sign in _PATTERN_SIGNS):
            return [text]
        root = None if os.path.isabs(pattern) else self._cwd
        return sorted(glob.glob(pattern, root_dir=root)) or [text]


def known_words(command: Command, arguments: Sequence[str]) -> list[str]:
    """The words of a command as far as they are known before it runs; '$' for one that is not."""
    known = Expansion({}, arguments, None, lambda line: '$')
    return [found for word in command.words for found in (known.fields(word) if _is_known(word) else ['$'])]


def _is_known(word: Word) -> bool:
    return all(piece.kind == 'text' or (piece.kind == 'name' and piece.text in '@*0123456789') for piece in word)
