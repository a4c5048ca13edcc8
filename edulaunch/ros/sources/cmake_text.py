"""Parses CMake's syntax: commands, quoted and unquoted words, comments and ${variables}."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

_TOKEN = re.compile(
    r"""
    (?P<comment>\#\[\[.*?\]\]|\#[^\n]*)
  | "(?P<quoted>(?:[^"\\]|\\.)*)"
  | (?P<paren>[()])
  | (?P<bare>(?:[^\s()"\#\\]|\\.)+)
  """,
    re.VERBOSE | re.DOTALL,
)
_VARIABLE = re.compile(r'\$\{([^${}]*)\}')


class Command(NamedTuple):
    """A command `name(words...)` at `line`. For each word, `quoted` contains whether the word is in quotation marks."""

    name: str
    line: int
    words: tuple[str, ...]
    quoted: tuple[bool, ...]


def commands(text: str) -> Iterator[Command]:
    """Yield the commands of a CMake file in order, with names in lower case. Other text is skipped."""
    name, line, depth = '', 0, 0
    words: list[tuple[str, bool]] = []
    for match in _TOKEN.finditer(text):
        kind, token = match.lastgroup, match[match.lastgroup or 0]
        if kind == 'comment':
            continue
        if kind != 'paren':
            if depth:
                words.append((token, kind == 'quoted'))
            else:
                name, line, words = token.lower(), text.count('\n', 0, match.start()) + 1, []
        elif token == '(':
            depth += 1
        elif depth:
            depth -= 1
            if depth == 0:
                yield Command(name, line, tuple(word for word, _ in words), tuple(quoted for _, quoted in words))


def expand(command: Command, variables: dict[str, list[str]], unknown: Callable[[str], None]) -> list[str]:
    """Return the words with the values of ${variables}. An unquoted word becomes one word for each item of its lists.

    A word with an unknown variable is left out, and `unknown(name)` is called.
    """
    result: list[str] = []
    for word, quoted in zip(command.words, command.quoted, strict=True):
        text, missing = _filled(word, variables)
        if missing is not None:
            unknown(missing)
        elif quoted:
            result.append(text)
        else:
            result += [part for part in text.split(';') if part]
    return result


def _filled(word: str, variables: dict[str, list[str]]) -> tuple[str, str | None]:
    """Return the word with its variables expanded from the inside out, and the name of the first unknown variable."""
    match = _VARIABLE.search(word)
    while match is not None:
        if match[1] not in variables:
            return word, match[1]
        word = word[: match.start()] + ';'.join(variables[match[1]]) + word[match.end() :]
        match = _VARIABLE.search(word)
    return word, None
