"""Shortens paths in what is reported: a report reads well, and is the same wherever it was made."""

from __future__ import annotations

import os
from dataclasses import replace

import edulaunch

from .place import Place
from .results import CheckResult

_ENGINE = os.path.join(os.path.dirname(os.path.abspath(edulaunch.__file__)), '')


class ShortPaths:
    """Writes paths of one report.

    :param folder: the submission's folder, absolute.
    :param shown: what is written in its place: '' or a path that ends in a separator.
    """

    def __init__(self, folder: str, shown: str = '') -> None:
        self._folder = os.path.join(folder, '')
        self._shown = shown

    def text(self, text: str | None) -> str | None:
        """A text with short paths; None stays None."""
        if text is None:
            return None
        return text.replace(self._folder, self._shown).replace(_ENGINE, 'edulaunch/')

    def place(self, place: Place | None) -> Place | None:
        """A place with a short path."""
        return None if place is None else Place(self.text(place.file) or '', place.line)

    def result(self, result: CheckResult) -> CheckResult:
        """A result with short paths in all its texts."""
        return replace(
            result, reason=self.text(result.reason) or '', expected=self.text(result.expected),
            seen=self.text(result.seen), where=self.place(result.where), try_=self.text(result.try_))
