"""The reader of advice (language, folder, notebook), and the translation of complete English sentences.

Reports are created and stored in English, so a rubric does not depend on languages. A complete sentence is translated with
the templates of a catalogue. For example, the template `'{thing} is missing'` matches 'the frame laser is missing'. The
facts of the sentence are inserted into the template of the other language. Facts that are sentences themselves are
translated, too.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cache
from string import Formatter
from typing import Any, NamedTuple

from edulaunch.engine.sim.task import AmbientTask, running_task
from edulaunch.engine.underlay_place import underlay_prefix

LOCALE = os.path.join(os.path.dirname(__file__), 'locale')
ENGLISH = 'en'


def _nowhere(file: str, line: int) -> str:
    return ''


_BUILT = re.compile(r"[^\s'\"]*/edulaunch-[^/\s]+/[^/\s]+/share/([^\s'\"]*)")
"""The path of a file in the share folder of a simulated build."""


def _source_of(path: str) -> str | None:
    real = os.path.realpath(path)
    return real if real != path and os.path.exists(real) else None


class Reader(NamedTuple):
    """The language, the folder and the notebook of a reader.

    :ivar language: the language, such as 'de'. The rules are in English, which is also used for languages without a catalogue.
    :ivar folder: the folder of the reader. Paths below this folder are shown as relative paths.
    :ivar cell: a function that returns the place in the notebook cell that wrote a line of a file, or an empty string.
    """

    language: str = ENGLISH
    folder: str = ''
    cell: Callable[[str, int], str] = _nowhere

    def says(self, text: str) -> str:
        """Return the translation of a sentence or template of edulaunch into the reader's language."""
        return text if self.language == ENGLISH else translations(self.language).get(text, text)

    def retells(self, text: str) -> str:
        """Return the translation of a complete English sentence, which edulaunch or a rubric has created."""
        return text if self.language == ENGLISH else _retelling(self.language)(text)

    def short(self, text: str) -> str:
        """Return a string without folders that are internal to edulaunch. A path in the reader's folder becomes a relative path.

        The path of a file in a simulated build becomes the path of the file in the sources, to which it is a link.
        """
        if 'edulaunch' in text:
            text = text.replace(os.path.join(underlay_prefix(), 'bin', ''), '')
            text = _BUILT.sub(lambda path: self.short(_source_of(path[0]) or f'share/{path[1]}'), text)
        return text.removeprefix(os.path.join(self.folder, '')) if len(self.folder) > 1 else text

    def place(self, file: str, line: int | None) -> str:
        """Return a place in a file as the reader sees it, such as 'follow.launch.py:12'.

        In a notebook, add the line of the cell that wrote the file.
        """
        short = self.short(file)
        if line is None:
            return short
        cell = self.cell(file, line)
        return f'{short}:{line} ({cell})' if cell else f'{short}:{line}'


def reader_of(env: Mapping[str, str], folder: str) -> Reader:
    """Return the reader of a terminal with these environment variables and this folder."""
    return Reader(language_of(env), folder)


def language_of(env: Mapping[str, str]) -> str:
    """Return the language that environment variables select: `EDULAUNCH_LANG`, or the language that gettext would use.

    The locale is the first value among `LC_ALL`, `LC_MESSAGES` and `LANG`. `LANGUAGE` lists languages by preference. As in
    gettext, `LANGUAGE` counts only if the locale is not `C` or `POSIX`. The first language with a catalogue is selected.
    """
    locale = next(filter(None, (env.get(name) for name in ('LC_ALL', 'LC_MESSAGES', 'LANG'))), 'C')
    wanted = [locale] if _plain_name(locale) in ('C', 'POSIX') else [*env.get('LANGUAGE', '').split(':'), locale]
    for name in map(_plain_name, [env.get('EDULAUNCH_LANG', ''), *wanted]):
        for language in filter(None, (name, name.partition('_')[0])):
            if language == ENGLISH or os.path.isdir(os.path.join(LOCALE, language)):
                return name
    return ENGLISH


def _plain_name(locale: str) -> str:
    """Return a locale without its encoding and variant, such as 'de_DE' for 'de_DE.UTF-8@euro'."""
    return locale.partition('.')[0].partition('@')[0]


def reader_here() -> Reader:
    """Return the reader who has started this program. On a shared machine, each program has the environment of its terminal."""
    task = running_task()
    env = os.environ if task is None or isinstance(task, AmbientTask) else getattr(task.owner, 'env', os.environ)
    try:
        folder = os.getcwd()
    except OSError:  # the current folder has been removed
        folder = ''
    reader = reader_of(env, folder)
    shell = getattr(sys.modules.get('IPython'), 'get_ipython', lambda: None)()
    return reader if shell is None else reader._replace(cell=_CellsOf(shell, reader))


class _CellsOf:
    """Finds the cell that wrote a file with `%%writefile` in the history of a notebook. The last such cell counts."""

    def __init__(self, shell: Any, reader: Reader) -> None:
        self._shell = shell
        self._reader = reader

    def __call__(self, file: str, line: int) -> str:
        cells = self._shell.history_manager.input_hist_raw
        for number in range(len(cells) - 1, 0, -1):
            first, _, body = cells[number].partition('\n')
            words = first.split()
            if words[:1] in (['%%writefile'], ['%%file']) and os.path.abspath(words[-1].strip('\'"')) == file:
                if '-a' in words or line > body.count('\n') + 1:
                    return ''
                return self._reader.says('line {line} of cell [{number}]').format(line=line + 1, number=number)
        return ''


def catalogue_file(language: str) -> str:
    """Return the path of a language's catalogue, which is a file of translations."""
    return os.path.join(LOCALE, language, 'LC_MESSAGES', 'advice.po')


@cache
def translations(language: str) -> dict[str, str]:
    """Return the translation of each English sentence. Return an empty dictionary for a language without a catalogue.

    :param language: a language such as 'de' or 'de_AT'. A country without its own catalogue uses the catalogue of the language.
    """
    for name in (language, language.partition('_')[0]):
        if os.path.isfile(catalogue_file(name)):
            with open(catalogue_file(name), encoding='utf-8') as file:
                return dict(_entries(file))
    return {}


def _entries(lines: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Yield each translated sentence of a .po file with its translation. Skip entries that are marked as fuzzy.

    These catalogues have no plurals and no contexts, and their strings are escaped as in JSON. Reading one takes 9 ms, so no
    compiled file is needed.
    """
    from json import JSONDecoder

    string = JSONDecoder(strict=False)  # accepts unescaped control characters
    parts: dict[str, list[str]] = {'msgid': [], 'msgstr': []}
    keyword, fuzzy = '', False
    for line in (*lines, ''):
        if not line.strip():
            english, other = (''.join(map(string.decode, parts[name])) for name in ('msgid', 'msgstr'))
            if english and other and not fuzzy:
                yield english, other
            parts, fuzzy = {'msgid': [], 'msgstr': []}, False
        elif line.startswith('#'):
            fuzzy = fuzzy or (line.startswith('#,') and 'fuzzy' in line)
        else:
            first, quote, rest = line.partition('"')
            keyword = first.strip() or keyword
            parts[keyword].append(quote + rest)


@cache
def _retelling(language: str) -> Retelling:
    return Retelling(translations(language))


_BARE = re.compile(r'\{(\w+)[^{}]*\}')
LONGEST = 2000
"""The maximum number of characters of a sentence. A longer string is the output of a program."""
DEEPEST = 3
LEAST = 8
"""At least one letter in this many must match templates. Otherwise, the sentence is not one of edulaunch's."""
MOST_TRIES = 500
"""The maximum number of facts to try for one string. A string that exceeds it is returned unchanged."""


_WORD = re.compile(r"(?<![\w/.:'\"-])[A-Za-z][a-z]+(?![\w/.:'\"=(-])")
"""A word of a sentence, but not a part of a name, a path, a call or a quotation."""
MOST_WORDS = 2
"""The maximum number of plain words in facts without a translation. With more, the sentence would mix two languages."""


class _Pattern(NamedTuple):
    """A template with fields, and its translation.

    :ivar texts: the strings before, between and after the fields.
    :ivar names: the names of the fields.
    :ivar template: the translation.
    """

    texts: tuple[str, ...]
    names: tuple[str, ...]
    template: str

    @property
    def bare(self) -> list[str]:
        """The names of the fields that have no quotation marks around them. A quoted fact may be in any language."""
        ends = zip(self.texts, self.texts[1:], self.names, strict=False)
        return [name for before, after, name in ends if not (before[-1:] == after[:1] != '' and after[:1] in '"\'')]

    def explains(self, foreign: list[str]) -> bool:
        """Return whether the result is mainly in the other language, although it contains facts that have no translation."""
        own = sum(len(_WORD.findall(text)) for text in self.texts)
        lines = [line for fact in foreign for line in fact.splitlines()[:1]]
        return max((len(_WORD.findall(line)) for line in lines), default=0) <= max(own, MOST_WORDS) - (own < 2)

    def facts(self, text: str) -> dict[str, str] | None:
        """Return the values of the fields by name, or None if the template does not match.

        Each value ends at the first occurrence of the string that follows the field.
        """
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
    """Translates complete sentences with the templates of a catalogue.

    :param catalogue: the translation of each English template. Both templates have the same fields.
    """

    def __init__(self, catalogue: Mapping[str, str]) -> None:
        self._whole = {_plain(english): _plain(other) for english, other in catalogue.items() if not fields_of(english)}
        found = [_pattern(english, other) for english, other in catalogue.items() if fields_of(english)]
        self._tries = 0
        self._patterns = [pattern for pattern in found if pattern is not None]

    def __call__(self, text: str) -> str:
        """Return the translation of a sentence, or the sentence itself if no template matches."""
        self._tries = 0
        return self._translated(text, DEEPEST)[1] if len(text) <= LONGEST else text

    def _translated(self, text: str, depth: int) -> tuple[int, str]:
        """Return the number of letters that templates match, and the translation.

        If several templates match, use the template that matches the most letters.
        """
        # a single word in a fact is a name, so it is not translated
        if text in self._whole and (depth == DEEPEST or ' ' in text):
            return len(text), self._whole[text]
        best, own = (0, text), 0
        self._tries += 1
        for pattern in self._patterns if depth and self._tries < MOST_TRIES else ():
            facts = pattern.facts(text)
            if facts is not None:
                translated = {name: self._translated(value, depth - 1) for name, value in facts.items()}
                known = sum(map(len, pattern.texts)) + sum(letters for letters, _ in translated.values())
                foreign = [facts[name] for name in pattern.bare if not translated[name][0]]
                size = sum(map(len, pattern.texts))
                is_better = (known, size) > (best[0], own) and known > len(text) // LEAST
                if is_better and pattern.explains(foreign):
                    own = size
                    best = known, pattern.template.format_map({name: words for name, (_, words) in translated.items()})
        return best


def fields_of(template: str) -> list[str]:
    """Return the names of the facts in a template."""
    return [name for _, name, _, _ in Formatter().parse(template) if name]


def _plain(template: str) -> str:
    """Return a template as a string, without its fields."""
    return ''.join(text for text, _, _, _ in Formatter().parse(template))


def _pattern(english: str, other: str) -> _Pattern | None:
    """Return the pattern of a template.

    Return None if no characters separate two fields, because then the end of the first field is unknown.
    """
    texts, names = [''], []
    for text, name, _, _ in Formatter().parse(english):
        texts[-1] += text
        if name:
            names.append(name)
            texts.append('')
    return _Pattern(tuple(texts), tuple(names), _BARE.sub(r'{\1}', other)) if all(texts[1:-1]) else None
