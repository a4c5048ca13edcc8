"""Attributes that a constructor sets and everybody may read."""

from __future__ import annotations

from typing import Any, Generic, TypeVar, overload

T = TypeVar('T')


class ReadOnly(Generic[T]):
    """A property `name` that gives the private attribute `__name` of its class; setting it is an AttributeError, as upstream.

    :param doc: what it is.
    """

    def __init__(self, doc: str) -> None:
        self.__doc__ = doc

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name
        self._attribute = f'_{owner.__name__.lstrip("_")}__{name}'

    @overload
    def __get__(self, instance: None, owner: type | None = None) -> ReadOnly[T]: ...

    @overload
    def __get__(self, instance: object, owner: type | None = None) -> T: ...

    def __get__(self, instance: object | None, owner: type | None = None) -> Any:
        return self if instance is None else getattr(instance, self._attribute)

    def __set__(self, instance: object, value: object) -> None:
        raise AttributeError(f"property '{self._name}' of '{type(instance).__name__}' object has no setter")
