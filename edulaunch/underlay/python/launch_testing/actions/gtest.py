"""A GoogleTest program."""

from __future__ import annotations

from typing import Any

from launch.some_substitutions_type import SomeSubstitutionsType

from .test import Test


class GTest(Test):
    """Run a GoogleTest program.

    :param path: of the program.
    :param timeout: seconds after which it is asked to end; None: never.
    """

    def __init__(self, *, path: SomeSubstitutionsType, timeout: float | None = None, **kwargs: Any) -> None:
        super().__init__(cmd=[path], timeout=timeout, **kwargs)
        self.__path = path

    @property
    def path(self) -> SomeSubstitutionsType:
        """Of the program."""
        return self.__path
