"""A literal string as a substitution."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from edulaunch.ros.read_only import ReadOnly

from ..substitution import Substitution

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class TextSubstitution(Substitution):
    """A literal string. Wherever substitutions are allowed, a plain string is converted to this class.

    :raises TypeError: when `text` is not a string.
    """

    def __init__(self, *, text: str) -> None:
        if not isinstance(text, str):
            raise TypeError(f"TextSubstitution expected Text object got '{type(text)}' instead.")
        self._text = text

    text: ReadOnly[str] = ReadOnly('The string.', '_text')

    def describe(self) -> str:
        """Return the string in quotes."""
        return f"'{self._text}'"

    def perform(self, context: LaunchContext) -> str:
        """Return the string."""
        return self._text


def describe_all(substitutions: Iterable[Substitution]) -> str:
    """Return the joined descriptions of several substitutions, such as `'a' + LaunchConfig('b')`."""
    return ' + '.join([substitution.describe() for substitution in substitutions])
