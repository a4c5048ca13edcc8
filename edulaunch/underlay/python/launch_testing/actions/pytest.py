"""A run of pytest."""

from __future__ import annotations

import sys
from typing import Any

from launch.some_substitutions_type import SomeSubstitutionsType

from .test import Test


class PyTest(Test):
    """Run pytest on a file or folder, as a real program of this machine.

    :param path: what to test.
    :param timeout: seconds after which it is asked to end; None: never.
    """

    def __init__(self, *, path: SomeSubstitutionsType, timeout: float | None = None, **kwargs: Any) -> None:
        super().__init__(cmd=[sys.executable, '-m', 'pytest', path], timeout=timeout, **kwargs)
        self.__path = path

    @property
    def path(self) -> SomeSubstitutionsType:
        """What is tested."""
        return self.__path
