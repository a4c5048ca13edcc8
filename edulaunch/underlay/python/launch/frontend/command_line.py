"""From the text of a command line, as in `cmd=` and `args=`, to its words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from edulaunch.facts import with_facts

from ..substitution import Substitution
from ..substitutions.text_substitution import TextSubstitution

Word = list[Substitution]

if TYPE_CHECKING:
    from .parser import Parser


def words_of(text: str, parser: Parser) -> list[Word]:
    """The words of a command line; each is a list of substitutions.

    Substitutions are found first, then the literal pieces between them are split as a shell would. What
    touches a substitution stays in one word with it, and what comes out of a substitution is never split.
    As upstream, a text of nothing, and blanks before the first substitution, are one empty word.

    :raises ValueError: when a quote is not closed within one literal piece.
    """
    words: list[Word] = []
    word: Word = []
    for piece in parser.parse_substitution(text):
        if not isinstance(piece, TextSubstitution):
            word.append(piece)
            continue
        tokens = _split(piece.text)
        if not tokens or (word and piece.text[0].isspace()):
            words.append(word)
            word = []
        for number, token in enumerate(tokens):
            if number:
                words.append(word)
                word = []
            word.append(TextSubstitution(text=token))
        if word and piece.text[-1:].isspace():
            words.append(word)
            word = []
    if word:
        words.append(word)
    return words


def _split(text: str) -> list[str]:
    if '"' not in text and "'" not in text and '\\' not in text:
        return text.split()
    from shlex import split

    try:
        return split(text)
    except ValueError as error:
        raise with_facts(error, 'launch.open-quote', text=text) from None
