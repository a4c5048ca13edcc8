"""The base class of substitutions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._parsed_by import ParsedByFrontend
from ._stable_repr import StableRepr

if TYPE_CHECKING:
    from .launch_context import LaunchContext


class Substitution(StableRepr):
    """A text that is not known before launch time, such as the value of a launch configuration.

    Subclasses give :meth:`perform`; :meth:`describe` is what `ros2 launch -s` shows.
    """

    parse = ParsedByFrontend('substitution')
    """Class method of those that are written `$(name ...)`: the class, and its keyword arguments for a list of arguments."""

    def describe(self) -> str:
        """What people read, without evaluating anything."""
        return repr(self)

    def perform(self, context: LaunchContext) -> str:
        """The text, evaluated in `context`.

        :raises NotImplementedError: in this base class, as upstream.
        """
        raise NotImplementedError('Substitution is an abstract base class')
