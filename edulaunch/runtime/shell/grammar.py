r"""The shell lines that run in the simulation, as data::

        line        = job {(';' | '&' | newline) job}
        job         = pipeline {('&&' | '||') pipeline}            in the background, if '&' follows it
        pipeline    = command {'|' command}
        command     = {NAME=word} {word | redirection}
        redirection = ['1' | '2' | '&'] ('>' | '>>') word | '2>&1' | '<' word
        word        = one or more of: letters, 'text', "text", \x, $NAME, ${NAME}, ${NAME:-text}, $0 to $9, $@, $*, $?, $(line),
                      `line`, a leading ~, and the patterns * ? [...]
        comment     = from a '#' that begins a word to the end of the line

Inside "..." the signs $ ` and \ keep their meaning. Other shell syntax (conditions, loops, functions, here-documents,
parentheses, arithmetic) is not supported here: :func:`parsed` returns None, and a real shell runs the line. Words
can contain variables, the output of other lines, and patterns.
"""

from __future__ import annotations

import glob
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

_SETTING = re.compile(r'([A-Za-z_]\w*)=')
_REDIRECTION = re.compile(r'([12]|&)?(>>?)(&1)?|<(?![<(&])')
_NAME = re.compile(r'\$(?:([A-Za-z_]\w*|[0-9@*?])|\{([A-Za-z_]\w*|[0-9@*?])(?::-([^{}$`"\'\\]*))?\})')
_RESERVED = frozenset(('if', 'for', 'while', 'until', 'case', 'function', 'select', '[[', '{', '}', '!'))
_ENDS_WORD = ' \t\n|&;<>()'


class Piece(NamedTuple):
    """A part of a word.

    :ivar kind: 'text', 'name' (of a variable) or 'line' (whose output is used).
    :ivar text: the literal text, or the name of the variable.
    :ivar is_quoted: whether the part stays in one word, and is never a pattern.
    :ivar default: the value if the variable is not set.
    """

    kind: str
    text: str
    is_quoted: bool
    default: str = ''
    line: tuple[Job, ...] = ()


Word = tuple[Piece, ...]


class Redirection(NamedTuple):
    """A redirection of 'stdin', 'stdout', 'stderr' or 'both'. If `place` is not given, the stream has the destination of
    stdout.
    """

    stream: str
    mode: str
    place: Word | None


class Command(NamedTuple):
    """The words of a command, with the variables that are set for it."""

    settings: tuple[tuple[str, Word], ...]
    words: tuple[Word, ...]
    redirections: tuple[Redirection, ...]


Pipeline = tuple[Command, ...]


class Job(NamedTuple):
    """Pipelines, each with the operator before it: '', '&&' or '||'."""

    parts: tuple[tuple[str, Pipeline], ...]
    is_beside: bool
    text: str


Line = tuple[Job, ...]


def parsed(text: str) -> Line | None:
    """Return the jobs of a line. Return None for an empty line, and for a line that is not in the grammar."""
    try:
        return _Reader(text).line('') or None
    except (_NotInGrammar, IndexError):
        return None


def commands(line: Line) -> Iterator[Command]:
    """Yield every command of a line, including commands in `$(...)`."""
    for job in line:
        for _, pipeline in job.parts:
            for command in pipeline:
                yield command
                for piece in (piece for word in command.words for piece in word):
                    yield from commands(piece.line)


def stands_for_more(text: str) -> bool:
    """Return whether a line contains variables or `$(...)`, so that its words are known only when it runs."""
    words = (word for command in commands(parsed(text) or ()) for word in command.words)
    return any(piece.kind != 'text' for word in words for piece in word)


class _NotInGrammar(Exception):
    pass


class _Reader:
    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0

    def _next(self) -> str:
        return self._text[self._at : self._at + 1]

    def _take(self, *signs: str) -> str:
        """Consume and return the first of these signs that comes next in the line. Return an empty string if no sign does."""
        found = next((sign for sign in signs if self._text.startswith(sign, self._at)), '')
        self._at += len(found)
        return found

    def _skip(self, blanks: str) -> None:
        while self._next() and self._next() in blanks or self._text.startswith('\\\n', self._at):
            self._at += 1 if self._next() != '\\' else 2
        if self._next() == '#':
            end = self._text.find('\n', self._at)
            self._at = len(self._text) if end < 0 else end
            self._skip(blanks)

    def line(self, end: str) -> Line:
        jobs: list[Job] = []
        while True:
            self._skip(' \t\n')
            if self._next() == end:
                return tuple(jobs)
            begin = self._at
            parts = [('', self._pipeline())]
            while joint := self._take('&&', '||'):
                self._skip(' \t\n')
                parts.append((joint, self._pipeline()))
            text = self._text[begin : self._at]
            sign = self._take(';', '&', '\n')
            if not sign and self._next() != end:
                raise _NotInGrammar
            jobs.append(Job(tuple(parts), sign == '&', text))

    def _pipeline(self) -> Pipeline:
        commands = [self._command()]
        while self._next() == '|' and not self._text.startswith(('||', '|&'), self._at):
            self._at += 1
            self._skip(' \t\n')
            commands.append(self._command())
        return tuple(commands)

    def _command(self) -> Command:
        settings: list[tuple[str, Word]] = []
        words: list[Word] = []
        redirections = []
        while True:
            self._skip(' \t')
            found = _REDIRECTION.match(self._text, self._at)
            if found is not None:
                redirections.append(self._redirection(found))
            elif not self._next() or self._next() in _ENDS_WORD:
                break
            elif not words and (name := _SETTING.match(self._text, self._at)):
                self._at = name.end()
                settings.append((name[1], self._word()))
            else:
                words.append(self._word())
        first = words[0] if words else ()
        if not (words or settings) or (''.join(piece.text for piece in first) in _RESERVED and not first[0].is_quoted):
            raise _NotInGrammar
        return Command(tuple(settings), tuple(words), tuple(redirections))

    def _redirection(self, found: re.Match[str]) -> Redirection:
        self._at = found.end()
        stream, sign, same = found.groups()
        if same:
            if stream != '2' or sign != '>':
                raise _NotInGrammar
            return Redirection('stderr', 'w', None)
        self._skip(' \t')
        place = self._word()
        if not place:
            raise _NotInGrammar
        if sign is None:
            return Redirection('stdin', 'r', place)
        return Redirection({'2': 'stderr', '&': 'both'}.get(stream, 'stdout'), 'w' if sign == '>' else 'a', place)

    def _word(self) -> Word:
        pieces: list[Piece] = []
        while self._next() and self._next() not in _ENDS_WORD:
            letter = self._next()
            if letter == "'":
                end = self._text.index("'", self._at + 1) if "'" in self._text[self._at + 1 :] else -1
                if end < 0:
                    raise _NotInGrammar
                pieces.append(Piece('text', self._text[self._at + 1 : end], True))
                self._at = end + 1
            elif letter == '"':
                self._at += 1
                pieces += self._quoted()
            elif letter == '\\':
                pieces.append(Piece('text', self._text[self._at + 1], True))
                self._at += 2
            else:
                pieces.append(self._special(False) or self._letter(False))
        return tuple(pieces)

    def _quoted(self) -> list[Piece]:
        pieces = [Piece('text', '', True)]
        while not self._take('"'):
            if not self._next():
                raise _NotInGrammar
            if self._next() == '\\' and self._text[self._at + 1] in '$`"\\\n':
                self._at += 1
            elif special := self._special(True):
                pieces.append(special)
                continue
            pieces.append(self._letter(True))
        return pieces

    def _letter(self, is_quoted: bool) -> Piece:
        self._at += 1
        return Piece('text', self._text[self._at - 1], is_quoted)

    def _special(self, is_quoted: bool) -> Piece | None:
        """Parse the expression that begins with a `$` or a backtick."""
        if self._text.startswith('$((', self._at):
            raise _NotInGrammar
        if self._take('$('):
            line = self.line(')')
            self._at += 1
            return Piece('line', '', is_quoted, line=line)
        if self._take('`'):
            end = self._text.find('`', self._at)
            line = _Reader(self._text[self._at : end]).line('') if end >= 0 else ()
            if not line:
                raise _NotInGrammar
            self._at = end + 1
            return Piece('line', '', is_quoted, line=line)
        name = _NAME.match(self._text, self._at)
        if name is None:
            if self._text.startswith('${', self._at):
                raise _NotInGrammar
            return None
        self._at = name.end()
        return Piece('name', name[1] or name[2], is_quoted, name[3] or '')


_PATTERN_SIGNS = '*?['


class Expansion:
    """Expands words.

    :param variables: values by name.
    :param arguments: `$0`, `$1` and so on.
    :param cwd: the folder in which patterns are expanded.
    :param written: a function that returns the output of a line in `$(...)`.
    """

    def __init__(
        self, variables: Mapping[str, str], arguments: Sequence[str], cwd: str | None, written: Callable[[Line], str]
    ) -> None:
        self._variables = variables
        self._arguments = arguments
        self._cwd = cwd
        self._written = written

    def words(self, words: Iterable[Word]) -> list[str]:
        """Expand the words. Each word may become several words, or no word."""
        return [found for word in words for found in self.fields(word)]

    def one(self, word: Word) -> str:
        """Expand a word that must remain one word, such as the name of a file or the value of a variable."""
        return ''.join(self._text(word, piece) if piece.kind == 'text' else self._value(piece) for piece in word)

    def fields(self, word: Word) -> list[str]:
        """Return the words that one word expands to."""
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
        """Return the words that begin with this piece, and whether they may be patterns. The first word continues the current
        one.
        """
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
    """Return the words of a command as far as they are known before it runs. An unknown word is replaced by '$'."""
    known = Expansion({}, arguments, None, lambda line: '$')
    return [found for word in command.words for found in (known.fields(word) if _is_known(word) else ['$'])]


def _is_known(word: Word) -> bool:
    return all(piece.kind == 'text' or (piece.kind == 'name' and piece.text in '@*0123456789') for piece in word)
