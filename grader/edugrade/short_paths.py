"""Makes texts of a report short, and the same wherever it was made: paths, temporary folders, addresses of objects."""

from __future__ import annotations

import os
import re
from dataclasses import replace

from edulaunch.underlay_place import engine_folder

from .place import Place
from .results import CheckResult

LONGEST_TEXT = 8000
_ENGINE = os.path.join(engine_folder(), '')
_WORD = re.compile(r'[^\s\'"]+')
# Files of a source package are run from a generated prefix, where they are links under this path.
_INSTALLED = re.compile(r'edulaunch-\w+/[^\s/]+-[0-9a-f]{8}/share/(?P<package>\w+)/')
_HOME = re.compile(r'edugrade-[0-9a-f]{16}/\d+')  # the private folder of a run


class ShortPaths:
    """Writes texts of one report.

    :param folder: the submission's folder, absolute.
    :param shown: what is written in its place: '' or a path that ends in a separator.
    :param package: the package that this folder is, if it is one.
    """

    def __init__(self, folder: str, shown: str = '', package: str | None = None) -> None:
        self._folder = os.path.join(folder, '')
        self._shown = shown
        self._package = package

    def text(self, text: str | None) -> str | None:
        """A text with short paths, of LONGEST_TEXT characters at most; None stays None."""
        if text is None:
            return None
        if len(text) > LONGEST_TEXT:
            text = f'{text[:LONGEST_TEXT]} ... and {len(text) - LONGEST_TEXT} characters more'
        text = text.replace(self._folder, self._shown).replace(_ENGINE, 'edulaunch/')
        if 'edulaunch-' in text or 'edugrade-' in text:
            text = _WORD.sub(lambda word: self._of_word(word[0]), text)
        if ' at 0x' not in text:
            return text
        from edulaunch.processes.addresses import Addresses

        return Addresses().steady(text)

    def _of_word(self, word: str) -> str:
        """A word without the generated beginning of a path."""
        installed = _last(_INSTALLED, word)
        if installed is not None:
            package = installed['package']
            return (self._shown if package == self._package else f'{package}/') + word[installed.end() :]
        home = _last(_HOME, word)
        return word if home is None else '~' + word[home.end() :]

    def place(self, place: Place | None) -> Place | None:
        """A place with a short path."""
        return None if place is None else Place(self.text(place.file) or '', place.line)

    def result(self, result: CheckResult) -> CheckResult:
        """A result with short paths in all its texts."""
        return replace(
            result,
            reason=self.text(result.reason) or '',
            expected=self.text(result.expected),
            seen=self.text(result.seen),
            where=self.place(result.where),
            try_=self.text(result.try_),
        )


def _last(pattern: re.Pattern[str], word: str) -> re.Match[str] | None:
    found = list(pattern.finditer(word))
    return found[-1] if found else None
