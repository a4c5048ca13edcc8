"""One element of a launch file in any format, as a parse function receives it."""

from __future__ import annotations

import typing
from abc import ABC, abstractmethod
from collections.abc import Collection
from typing import Any

from edulaunch.engine.nearest import nearest

from . import places

Pair = tuple[str, Any, int]
"""Two attributes of an element, and its line."""


class Entity(ABC):
    """One element: its name, its attributes and the elements inside it.

    If no parse function requests an attribute or a child, parsing raises an error, because the name is usually misspelt.
    """

    __slots__ = ('asked',)

    asked: set[str]
    """The names that a parse function has requested so far. In XML, these are only names of attributes."""

    @property
    @abstractmethod
    def type_name(self) -> str:
        """The name of the element, such as `node`."""

    @property
    @abstractmethod
    def parent(self) -> Entity | None:
        """The enclosing element, or None for the root element."""

    @property
    @abstractmethod
    def children(self) -> list[Entity]:
        """The elements inside this element. Reading this property marks them as requested."""

    @property
    def line(self) -> int:
        """The line of the element in the file, from 1; 0 if the line is unknown. (edulaunch only.)"""
        return 0

    @property
    def shown(self) -> str:
        """The element as error messages show it. (edulaunch only.)"""
        return f"'{self.type_name}'"

    @abstractmethod
    def get_attr(self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True) -> Any:
        """Return the attribute `name`.

        :param data_type: one of launch's allowed types, None for any of them, or `List[Entity]` for children.
        :param optional: return None when the attribute is missing.
        :param can_be_str: whether a string is also allowed. It may contain substitutions.
        :raises AttributeError: when the attribute is missing and not optional.
        :raises TypeError: when the attribute has another type.
        """

    def given(self, attributes: Collection[str], children: Collection[str] = ()) -> list[str]:
        """Return the existing `attributes` and then the existing `children`, and mark all of them as requested.

        A format can override this method. One call of this method is much faster than one request for each name. (edulaunch
        only.)
        """
        return [name for name in attributes if self._has(name, None)] + [name for name in children if self._has(name, Entities)]

    def plain_pairs(self, tag: str, first: str, second: str, *, is_typed: bool = False) -> list[Pair] | None:
        """Return (first, second, line) for each child called `tag`, if each child has exactly the attributes `first` and
        `second`.

        Return None if the caller must request each attribute. Most elements of a long file have this form, so formats can return
        quickly without creating entities. (edulaunch only.)

        :param is_typed: whether the second value is converted according to YAML's rules. Otherwise, both values are strings.
        """
        return None

    def _has(self, name: str, data_type: Any) -> bool:
        try:
            return self.get_attr(name, data_type=data_type, optional=True) is not None
        except (TypeError, ValueError):
            return True

    @abstractmethod
    def assert_entity_completely_parsed(self) -> None:
        """Raise ValueError if attributes or children were not requested. The message contains their names."""

    def _unexpected(self, what: str, names: list[str], kind: str | None = None) -> ValueError:
        """Return the error for names that were not requested. The message lists them as Python shows a set, but in order.

        :param kind: 'attribute' or 'element' if the element has an attribute or element with the first of these names; otherwise
            None.
        """
        listed = '{' + ', '.join(repr(name) for name in sorted(names)) + '}'
        error = ValueError(f'Unexpected {what} found in `{self.type_name}`: {listed}')
        name = str(names[0])
        return places.at(error, self, 'launch.unknown-attribute', attribute=name, kind_of=kind, near=nearest(name, self._known))

    def _missing(self, error: AttributeError, name: str) -> AttributeError:
        """Return the error for a missing required name. The facts list the names in the file that were not requested."""
        kind, _, wanted = name.rpartition(' ')
        present = [str(one) for one in self._names if one not in self.asked]
        return places.at(error, self, 'launch.missing-attribute', needed=wanted.strip("'"), given_names=present)

    @property
    def _known(self) -> Collection[str]:
        """The names that the element could have, as far as parse functions have requested them."""
        return self.asked

    @property
    def _names(self) -> Collection[str]:
        """The names of all attributes or keys in the file."""
        return ()


Entities = typing.List[Entity]  # noqa: UP006 (error messages name exactly this type)
"""The data type with which a parse function requests child elements."""


def check_is_list_entity(data_type: Any) -> bool:
    """Return whether the data type is `List[Entity]`, or a list of a subclass of `Entity`."""
    if data_type is Entities:
        return True
    if getattr(data_type, '__origin__', None) is not list:
        return False
    item_type = (data_type.__args__ or (None,))[0]
    return isinstance(item_type, type) and issubclass(item_type, Entity)
