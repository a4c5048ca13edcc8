"""Finished English sentences in another language: a catalogue's templates are read backwards.

Reports are made, kept and sent in English, and a rubric needs no word about languages: `'{thing} is missing'` finds the facts of
'the frame laser is missing' again, and they go into the other language's template. Facts that are sentences themselves are
retold, too.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from string import Formatter
from typing import NamedTuple

_BARE = re.compile(r'\{(\w+)[^{}]*\}')
LONGEST = 2000
"""Characters: a longer text is a program's output, not a sentence of ours."""
DEEPEST = 3
LEAST = 8
"""One letter of so many has to stand in templates: else it is somebody else's sentence with a word of ours in it."""
MOST_TRIES = 500
"""Facts that are looked at in one text: whoever writes one that fits everywhere gets it back as it is."""


class _Pattern(NamedTuple):
    """A template: the texts before, between and behind its fields, their names, and the other language's template."""

    texts: tuple[str, ...]
    names: tuple[str, ...]
    template: str

    def facts(self, text: str) -> dict[str, str] | None:
        """What stands in the fields; each ends where the next text begins first. None when the texts do not fit."""
        first, *between, last = self.texts
        if not text.startswith(first) or not text.endswith(last) or len(text) <= len(first) + len(last):
            return None
        rest, values = text[len(first) : len(text) - len(last)], []
        for part in between:
            value, found, rest = rest.partition(part)
            if not found or not value:
                return None
            values.append(value)
        return dict(zip(self.names, [*values, rest], strict=True)) if rest else None


class Retelling:
    """Retells sentences by a catalogue.

    :param catalogue: English template -> template of the other language, with the same fields.
    """

    def __init__(self, catalogue: Mapping[str, str]) -> None:
        self._whole = {_plain(english): _plain(other) for english, other in catalogue.items() if not fields_of(english)}
        found = [_pattern(english, other) for english, other in catalogue.items() if fields_of(english)]
        self._tries = 0
        self._patterns = [pattern for pattern in found if pattern is not None]

    def __call__(self, text: str) -> str:
        """The sentence in the other language; as it is when no template fits."""
        self._tries = 0
        return self._retold(text, DEEPEST)[1] if len(text) <= LONGEST else text

    def _retold(self, text: str, depth: int) -> tuple[int, str]:
        """How many letters of a text stand in templates, its facts' templates among them, and the text in the other language. Of
        several templates that fit, the one that explains most of the text is meant.
        """
        if text in self._whole:
            return len(text), self._whole[text]
        best = (0, text)
        self._tries += 1
        for pattern in self._patterns if depth and self._tries < MOST_TRIES else ():
            facts = pattern.facts(text)
            if facts is not None:
                told = {name: self._retold(value, depth - 1) for name, value in facts.items()}
                known = sum(map(len, pattern.texts)) + sum(letters for letters, _ in told.values())
                if known > max(best[0], len(text) // LEAST):
                    best = known, pattern.template.format_map({name: words for name, (_, words) in told.items()})
        return best


def fields_of(template: str) -> list[str]:
    """Names of the facts in a template."""
    return [name for _, name, _, _ in Formatter().parse(template) if name]


def _plain(template: str) -> str:
    """A template without fields as a text."""
    return ''.join(text for text, _, _, _ in Formatter().parse(template))


def _pattern(english: str, other: str) -> _Pattern | None:
    """None for fields that nothing parts: nobody can say where one of them ends."""
    texts, names = [''], []
    for text, name, _, _ in Formatter().parse(english):
        texts[-1] += text
        if name:
            names.append(name)
            texts.append('')
    return _Pattern(tuple(texts), tuple(names), _BARE.sub(r'{\1}', other)) if all(texts[1:-1]) else None
