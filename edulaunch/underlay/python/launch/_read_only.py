"""Attributes that a constructor sets and everybody may read."""

from __future__ import annotations

from operator import attrgetter
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

T = TypeVar('T')


class ReadOnly(Generic[T]):
    """A property `name` that gives the private attribute `__name` of its class; setting it is an AttributeError, as upstream.

    :param doc: what it is.
    """

    def __init__(self, doc: str) -> None:
        self.__doc__ = doc

    def __set_name__(self, owner: type, name: str) -> None:
        getter = attrgetter(f'_{owner.__name__.lstrip("_")}__{name}')
        setattr(owner, name, property(getter, doc=self.__doc__))

    if TYPE_CHECKING:

        @overload
        def __get__(self, instance: None, owner: type | None = None) -> ReadOnly[T]: ...

        @overload
        def __get__(self, instance: object, owner: type | None = None) -> T: ...

        def __get__(self, instance: object | None, owner: type | None = None) -> Any: ...

        def __set__(self, instance: object, value: object) -> None: ...
