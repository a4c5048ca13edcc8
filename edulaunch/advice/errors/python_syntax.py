"""Rules about files that Python cannot parse. The rules read Python's error message and the failing line."""

from __future__ import annotations

import re
from collections.abc import Iterator
from linecache import getline
from typing import Any

from edulaunch.advice.rule import Failure, Finding, Rule, found, rule

SYNTAX = ('SyntaxError', 'IndentationError', 'TabError', 'InvalidPythonLaunchFileError')
CLOSING = {'(': ')', '[': ']', '{': '}'}
QUOTES = '\u2018\u2019\u201a\u201b\u201c\u201d\u201e\u201f\u00ab\u00bb\u2032\u2033\u00b4`'
STRAIGHT = {
    **dict.fromkeys('\u2010\u2011\u2013\u2014\u2212', '-'),
    **dict.fromkeys('\u00a0\u2009\u202f\u200b', 'an ordinary space'),
    '\uff0c': ',',
    '\uff08': '(',
    '\uff09': ')',
}
_BLOCK = re.compile(r"expected an indented block after (?:'(\w+)' statement|(\w+) definition) on line (\d+)")
_CHARACTER = re.compile(r"invalid (?:character '.' \(|non-printable character )U\+([0-9A-F]{4,6})")


def _matched(failure: Failure, pattern: str, types: tuple[str, ...] = SYNTAX) -> re.Match[str] | None:
    return re.search(pattern, failure.message) if failure.type in types else None


def _in_line(failure: Failure, **facts: Any) -> Finding:
    return found('process', failure.process or '', file=failure.file, line=failure.line, time_s=failure.time_s, **facts)


@rule(
    'programs.typographic-quotes',
    what='Python cannot read the character {character} ({code}), which a word processor or a web page inserts',
    do=(
        'replace {quote} with a straight quote: \' or "',
        'replace it with {straight}',
        'delete the character, and type the line again',
    ),
    level='error',
)
def typographic_quotes(failure: Failure) -> Iterator[Finding]:
    """Report typographic quotes and dashes, which look almost like the ASCII characters."""
    match = _matched(failure, _CHARACTER.pattern)
    if match is not None:
        character = chr(int(match[1], 16))
        quote = character if character in QUOTES else None
        shown = character if character.isprintable() and not character.isspace() else 'here'
        yield _in_line(failure, character=shown, code=f'U+{match[1]}', straight=STRAIGHT.get(character), quote=quote)


@rule(
    'programs.bracket-open',
    what='the bracket {opening} of this line is never closed',
    why='Python reads to the end of the file and does not find {closing}',
    do='write {closing} where the list or the call ends',
    level='error',
)
def bracket_open(failure: Failure) -> Iterator[Finding]:
    """Report a bracket that is never closed. Python names the line of the opening bracket."""
    match = _matched(failure, r"'([(\[{])' was never closed")
    if match is not None:
        yield _in_line(failure, opening=match[1], closing=CLOSING[match[1]])


@rule(
    'programs.bracket-other',
    what=(
        "'{closing}' cannot close the '{opening}' on line {opened}, which needs '{wanted}'",
        "'{closing}' cannot close '{opening}', which needs '{wanted}'",
    ),
    do="write '{wanted}' before this '{closing}' or instead of it",
    level='error',
)
def bracket_other(failure: Failure) -> Iterator[Finding]:
    """Report a closing bracket that does not match the opening bracket."""
    match = _matched(failure, r"closing parenthesis '(.)' does not match opening parenthesis '(.)'(?: on line (\d+))?")
    if match is not None:
        opened = int(match[3]) if match[3] else None
        yield _in_line(failure, closing=match[1], opening=match[2], wanted=CLOSING[match[2]], opened=opened)


@rule(
    'programs.bracket-too-many',
    what='this {closing} has no opening bracket',
    do='remove it, or add the opening bracket before it',
    level='error',
)
def bracket_too_many(failure: Failure) -> Iterator[Finding]:
    """Report a closing bracket without an opening bracket."""
    match = _matched(failure, r"unmatched '(.)'")
    if match is not None:
        yield _in_line(failure, closing=match[1])


@rule(
    'programs.not-utf-8',
    what='this file is not encoded in UTF-8',
    why='some editors save files in UTF-16 or another encoding, but Python and ROS 2 read UTF-8',
    do='save the file again in UTF-8',
    level='error',
)
def not_utf_8(failure: Failure) -> Iterator[Finding]:
    """Report a file whose encoding is not UTF-8. A file in UTF-16 contains many null bytes.

    Some versions of Python do not name the file. In that case, the finding names the program.
    """
    types = (*SYNTAX, 'ValueError', 'UnicodeDecodeError')
    if _matched(failure, r"null bytes|can't decode byte|Non-UTF-8 code|invalid or missing encoding", types):
        file = None if failure.process else failure.file
        yield found('process', failure.process or '', file=file, time_s=failure.time_s)


@rule(
    'programs.indentation',
    what=(
        'the line after line {opened} is not indented',
        'line {deeper} is indented further than the line above, which does not begin a block',
        'the indentation of this line does not match any line above',
    ),
    why='Python uses the indentation to decide which lines belong together',
    do=(
        'indent the line by four spaces, because it belongs to the {statement}',
        'indent line {deeper} like the line above, or add the line that begins the block, such as def or if',
        'indent each level by four spaces, and do not use tabs',
    ),
    level='error',
)
def indentation(failure: Failure) -> Iterator[Finding]:
    """Report missing or unexpected indentation, and tabs that are mixed with spaces."""
    if failure.type in ('IndentationError', 'TabError'):
        match = re.search(
            r"expected an indented block after (?:'(\w+)' statement|(\w+) definition) on line (\d+)", failure.message
        )
        statement = None if match is None else match[1] or match[2]
        deeper = failure.line if failure.message.startswith('unexpected indent') else None
        yield _in_line(failure, opened=None if match is None else int(match[3]), statement=statement, deeper=deeper)


def _simple(name: str, pattern: str, what: str, do: str, unless: str = r'(?!)') -> Rule:
    """Return a rule that explains an error message of Python in one sentence.

    :param name: the name of the rule.
    :param pattern: a regular expression for the message.
    :param what: the sentence about the mistake.
    :param do: the sentence about what to do.
    :param unless: a regular expression for the failing line. If it matches, the rule reports nothing.
    """

    def look(failure: Failure) -> Iterator[Finding]:
        if _matched(failure, pattern) and not re.search(unless, getline(failure.file or '', failure.line or 0)):
            yield _in_line(failure)

    return rule(name, what=what, do=do, level='error')(look)


NO_COMMA = _simple(
    'programs.no-comma',
    r'Perhaps you forgot a comma',
    'a comma is missing in this line, or at the end of the line above',
    'write a comma between the two values',
    unless=r'\w\[\]',  # as in `parameters: list[]`, where Python suggests a comma
)
NO_COLON = _simple(
    'programs.no-colon', r"expected ':'", 'a colon is missing at the end of this line', 'write a colon at the end of the line'
)
OPEN_TEXT = _simple(
    'programs.open-text',
    r'unterminated (?:triple-quoted |f-)?string literal|EOL while scanning',
    'a string starts in this line and does not end',
    'add the closing quote, which must be the same character as the opening quote',
)
ONE_EQUALS = _simple(
    'programs.one-equals', r"Maybe you meant '=='", 'a single = assigns a value, but a comparison needs ==', 'write == to compare'
)
NO_COLON_IN_BRACES = _simple(
    'programs.no-colon-in-braces',
    r"':' expected after dictionary key",
    'a key in this dictionary has no value',
    'write a colon between the key and its value, and a comma after the value',
)
VALUE_AFTER_NAMES = _simple(
    'programs.value-after-names',
    r'positional argument follows keyword argument',
    'an argument without a name follows arguments with names',
    'write the name of the argument before the value, or move the value before the arguments with names',
)
