"""The base class of substitutions."""

from __future__ import annotations

import collections.abc
from collections.abc import Iterable
from typing import TYPE_CHECKING

from ._bases import ParsedByFrontend, StableRepr

if TYPE_CHECKING:
    from .launch_context import LaunchContext


class Substitution(StableRepr):
    """A string that is known only at launch time, such as the value of a launch configuration.

    Subclasses define :meth:`perform`; `ros2 launch -s` shows :meth:`describe`.
    """

    parse = ParsedByFrontend('substitution')
    """Class method of substitutions written as `$(name ...)`: returns the class, and its keyword arguments for a list of
    arguments.
    """

    def describe(self) -> str:
        """Return a description of the substitution, without evaluating anything."""
        return repr(self)

    def perform(self, context: LaunchContext) -> str:
        """Return the evaluated string.

        :raises NotImplementedError: in this base class, as in upstream.
        """
        raise NotImplementedError('Substitution is an abstract base class')


SomeSubstitutionsType = str | Substitution | Iterable[str | Substitution]
"""A string, a substitution, or several of them, which are joined without a separator."""

SomeSubstitutionsType_types_tuple = (str, Substitution, collections.abc.Iterable)
