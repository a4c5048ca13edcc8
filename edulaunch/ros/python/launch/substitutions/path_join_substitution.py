"""The substitution `PathJoinSubstitution`."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING

from .._bases import ReadOnly
from ..substitution import Substitution
from ..utilities.texts import normalize_to_list_of_substitutions
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class PathJoinSubstitution(Substitution):
    """The parts, joined as `os.path.join` does.

    :param substitutions: the parts, each a string or one substitution. A list inside the list is a TypeError in Jazzy.
    """

    def __init__(self, substitutions: Iterable[str | Substitution]) -> None:
        self.__substitutions = normalize_to_list_of_substitutions(substitutions)

    substitutions: ReadOnly[list[Substitution]] = ReadOnly('The parts.')

    def describe(self) -> str:
        """Return a description such as `PathJoin(''a' + LaunchConfig('b')')`."""
        return f"PathJoin('{describe_all(self.__substitutions)}')"

    def perform(self, context: LaunchContext) -> str:
        """Return the joined path."""
        return os.path.join(*[part.perform(context) for part in self.__substitutions])
