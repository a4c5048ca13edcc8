"""Who reads: in which language, from which folder, and in which notebook."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from gettext import NullTranslations

    from edulaunch.advice.retelling import Retelling

LOCALE = os.path.join(os.path.dirname(__file__), 'locale')
ENGLISH = 'en'


def _nowhere(file: str, line: int) -> str:
    return ''


class Reader(NamedTuple):
    """
    :ivar language: such as 'de'; English is what stands in the rules, and is told where a language has no catalogue.
    :ivar folder: paths below it are told from there.
    :ivar cell: what to say of a line of a file that a cell of the reader's notebook wrote: its place there, or ''.
    """

    language: str = ENGLISH
    folder: str = ''
    cell: Callable[[str, int], str] = _nowhere

    def says(self, text: str) -> str:
        """A sentence of ours in the reader's language."""
        return _catalogue(self.language).gettext(text) if text and self.language != ENGLISH else text

    def retells(self, text: str) -> str:
        """A finished English sentence of ours, or of a rubric, in the reader's language."""
        return text if self.language == ENGLISH else _retelling(self.language)(text)

    def place(self, file: str, line: int | None) -> str:
        """A place in a file as the reader sees it: 'follow.launch.py:12', in a notebook with the line of the cell."""
        below = os.path.join(self.folder, '')
        short = file.removeprefix(below) if self.folder else file
        if line is None:
            return short
        cell = self.cell(file, line)
        return f'{short}:{line} ({cell})' if cell else f'{short}:{line}'


def reader_of(env: Mapping[str, str], folder: str) -> Reader:
    """Who reads in a terminal with these variables, in that folder. `EDULAUNCH_LANG` alone names the language, so that the same
    notebook says the same on every machine.
    """
    return Reader(env.get('EDULAUNCH_LANG', '').partition('.')[0] or ENGLISH, folder)


def reader_here() -> Reader:
    """Who started this program."""
    try:
        folder = os.getcwd()
    except OSError:  # it has been removed
        folder = ''
    reader = reader_of(os.environ, folder)
    shell = getattr(sys.modules.get('IPython'), 'get_ipython', lambda: None)()
    return reader if shell is None else reader._replace(cell=_CellsOf(shell, reader))


class _CellsOf:
    """Which cell wrote a file with `%%writefile`, from the history of a notebook: of several the last."""

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


@cache
def _catalogue(language: str) -> NullTranslations:
    from gettext import translation

    return translation('advice', LOCALE, [language, language.partition('_')[0]], fallback=True)


@cache
def _retelling(language: str) -> Retelling:
    from edulaunch.advice.retelling import Retelling

    catalogue = getattr(_catalogue(language), '_catalog', {})
    return Retelling({english: other for english, other in catalogue.items() if english and isinstance(english, str)})
