"""The base class of conditions."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from ._bases import StableRepr

if TYPE_CHECKING:
    from .launch_context import LaunchContext


class Condition(StableRepr):
    """Decides at launch time whether an action is executed.

    :param predicate: a function that is called with the launch context. Without a predicate, the condition is false.
    """

    def __init__(self, *, predicate: Callable[[LaunchContext], bool] | None = None) -> None:
        self._predicate = predicate

    @property
    def in_words(self) -> str:
        """A readable form of the condition for a plan. (edulaunch only.)"""
        return f'if {type(self).__name__} says so'

    def describe(self) -> str:
        """Return a description of the condition, which is the `repr` in this base class."""
        return repr(self)

    def evaluate(self, context: LaunchContext) -> bool:
        """Return the current value of the condition."""
        return self._predicate(context) if self._predicate is not None else False
