"""A value of the context's locals."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

from ..substitution import Substitution

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class LocalSubstitution(Substitution):
    """`context.locals.<expression>`; mostly `event.<something>` inside an event handler.

    :param description: for people, instead of the expression.
    :raises AttributeError: on evaluation, when there is no such local.
    """

    def __init__(self, expression: str, description: Optional[str] = None) -> None:
        self.__expression = expression
        self.__description = description

    @property
    def expression(self) -> str:
        """The dotted name."""
        return self.__expression

    def describe(self) -> str:
        """`LocalVar('event.reason')`."""
        return f"LocalVar('{self.__expression if self.__description is None else self.__description}')"

    def perform(self, context: LaunchContext) -> str:
        """The value, which need not be a text."""
        value: Any = context.locals
        for name in self.__expression.split('.'):
            value = getattr(value, name)
        return value  # type: ignore[no-any-return]
