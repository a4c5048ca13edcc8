"""Read-only properties that return a private attribute."""

from __future__ import annotations

from operator import attrgetter
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

T = TypeVar('T')


class ReadOnly(Generic[T]):
    """A property `name` that returns the private attribute `__name` of its class. As in upstream, an assignment to the property
    raises AttributeError.

    :param doc: the docstring of the property.
    :param path: the attribute of `self` to return instead, which may be dotted.
    """

    def __init__(self, doc: str, path: str | None = None) -> None:
        self.__doc__ = doc
        self._path = path

    def __set_name__(self, owner: type, name: str) -> None:
        path = self._path or f'__{name}'
        getter = attrgetter(f'_{owner.__name__.lstrip("_")}{path}' if path.startswith('__') else path)
        setattr(owner, name, property(getter, doc=self.__doc__))

    if TYPE_CHECKING:

        @overload
        def __get__(self, instance: None, owner: type | None = None) -> ReadOnly[T]: ...

        @overload
        def __get__(self, instance: object, owner: type | None = None) -> T: ...

        def __get__(self, instance: object | None, owner: type | None = None) -> Any: ...

        def __set__(self, instance: object, value: object) -> None: ...
