"""The error for a launch file that cannot be loaded."""

from __future__ import annotations

from collections.abc import Sequence


class InvalidLaunchFileError(Exception):
    """A launch file cannot be loaded.

    :param extension: the extension of the file, without its dot.
    :param likely_errors: the error of each loader that was tried. The first error becomes the `__cause__`.
    """

    def __init__(self, extension: str = '', *, likely_errors: Sequence[BaseException] = ()) -> None:
        self._extension = extension
        self.likely_errors = list(likely_errors)
        if self._extension and self.likely_errors:
            self.__cause__ = self.likely_errors[0]
        super().__init__(self._text())

    def __str__(self) -> str:
        return self._text()

    def _text(self) -> str:
        if not self._extension or not self.likely_errors:
            return 'The launch file may have a syntax error, or its format is unknown'
        first = 'Caught exception' if len(self.likely_errors) == 1 else 'Caught multiple exceptions'
        lines = [f'{first} when trying to load file of format [{self._extension}]:']
        lines += [f' - {type(error).__name__}: {error}' for error in self.likely_errors]
        return '\n'.join(lines)
