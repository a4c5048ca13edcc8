"""Shortens paths in what is reported: a report reads well, and is the same wherever it was made."""

from __future__ import annotations

import os
import re
from dataclasses import replace

import edulaunch

from .place import Place
from .results import CheckResult

_ENGINE = os.path.join(os.path.dirname(os.path.abspath(edulaunch.__file__)), '')
# Files of a source package are run from a generated prefix, where they are links under this path.
_INSTALLED = re.compile(r'(?:[^\s\'"]*/)?edulaunch-\w+/[^\s/]+-[0-9a-f]{8}/share/(?P<package>\w+)/')


class ShortPaths:
    """Writes paths of one report.

    :param folder: the submission's folder, absolute.
    :param shown: what is written in its place: '' or a path that ends in a separator.
    :param package: the package that this folder is, if it is one.
    """

    def __init__(self, folder: str, shown: str = '', package: str | None = None) -> None:
        self._folder = os.path.join(folder, '')
        self._shown = shown
        self._package = package

    def text(self, text: str | None) -> str | None:
        """A text with short paths; None stays None."""
        if text is None:
            return None
        text = text.replace(self._folder, self._shown).replace(_ENGINE, 'edulaunch/')
        return _INSTALLED.sub(self._source_of, text) if 'edulaunch-' in text else text

    def _source_of(self, installed: re.Match[str]) -> str:
        package = installed['package']
        return self._shown if package == self._package else f'{package}/'

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
