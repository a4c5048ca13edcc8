"""The substitution `LocalSubstitution`."""

from __future__ import annotations

from functools import lru_cache
from types import CodeType
from typing import TYPE_CHECKING

from .._bases import ReadOnly
from ..substitution import Substitution

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class LocalSubstitution(Substitution):
    """The value of `context.locals.<expression>`, such as `event.<something>` inside an event handler.

    :param expression: a name, optionally followed by `.attribute` or `['key']` as in Python.
    :param description: the description for `ros2 launch -s`, instead of the expression.
    :raises AttributeError: on evaluation, when there is no such local.
    """

    def __init__(self, expression: str, description: str | None = None) -> None:
        self.__expression = expression
        self.__description = description

    expression: ReadOnly[str] = ReadOnly('The Python expression after `context.locals.`.')

    def describe(self) -> str:
        """Return a description such as `LocalVar('event.reason')`."""
        return f"LocalVar('{self.__expression if self.__description is None else self.__description}')"

    def perform(self, context: LaunchContext) -> str:
        """Return the value, which need not be a string."""
        value: str = eval(_compiled(self.__expression), {}, {'context': context})
        return value


@lru_cache(maxsize=256)
def _compiled(expression: str) -> CodeType:
    return compile('context.locals.' + expression, '<string>', 'eval')
