"""An XML element as the parse functions receive it."""

from __future__ import annotations

import re
from collections.abc import Collection
from typing import Any

from launch.frontend import places
from launch.frontend.entity import Entities, Pair, check_is_list_entity
from launch.frontend.entity import Entity as BaseEntity
from launch.utilities.type_utils import get_typed_value

# A string that YAML 1.1 certainly reads as a string, unless it is one of the words below. It is ASCII, begins like a word or a
# substitution, has no colon or comment, and does not end with a space. (YAML's own reader needs 50 us for it.)
_PLAIN = re.compile(r'[A-Za-z$_/](?:[ !"$-9;-~]*[!"$-9;-~])?')
_WORDS_WITH_A_MEANING = frozenset(('true', 'false', 'yes', 'no', 'on', 'off', 'null'))


def typed(value: str | list[str], data_type: Any, can_be_str: bool) -> Any:
    """Convert a string to a data type. Without a type, the rules of YAML apply.

    :param can_be_str: whether to return the string itself if it cannot be converted, because it may contain a substitution.
    :raises ValueError: when the string cannot be converted.
    """
    if data_type is None and isinstance(value, str):
        if _PLAIN.fullmatch(value) and value.lower() not in _WORDS_WITH_A_MEANING:
            return value
        if value.isdecimal() and value.isascii() and (value[0] != '0' or value == '0'):
            return int(value)
    return get_typed_value(value, data_type, can_be_str)


SEPARATOR = '-sep'
"""`values="1,2" values-sep=","` is a list."""


class Entity(BaseEntity):
    """An XML element.

    :param xml_element: an element with `tag`, `attrib` and its children as items, like `xml.etree.ElementTree.Element`.
    :param parent: the enclosing element.
    """

    __slots__ = ('_element', '_attributes', '_parent', '_children_asked', '_asked_tags')

    def __init__(self, xml_element: Any, *, parent: Entity | None = None) -> None:
        self._element = xml_element
        self._attributes: dict[str, str] = xml_element.attrib
        self._parent = parent
        self._children_asked = False
        self.asked: set[str] = set()
        self._asked_tags: Collection[str] = ()

    @property
    def type_name(self) -> str:
        return self._element.tag  # type: ignore[no-any-return]

    @property
    def parent(self) -> Entity | None:
        return self._parent

    @property
    def line(self) -> int:
        return getattr(self._element, 'line', 0)

    @property
    def shown(self) -> str:
        return f'<{self._element.tag}>'

    @property
    def children(self) -> list[BaseEntity]:
        self._children_asked = True
        return [Entity(child, parent=self) for child in self._element]

    def get_attr(self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True) -> Any:
        """Return an attribute, converted from its string. For `List[Entity]`, return the child elements called `name`."""
        if data_type is not Entities and (data_type is str or data_type is None or not check_is_list_entity(data_type)):
            self.asked.add(name)
            text = self._attributes.get(name)
            if text is not None:
                return text if data_type is str else self._typed(name, text, data_type, can_be_str)
        else:
            if name not in self._asked_tags:
                self._asked_tags = {*self._asked_tags, name}
            found = [Entity(child, parent=self) for child in self._element if child.tag == name]
            if found:
                return found
        if optional:
            return None
        raise self._missing(
            AttributeError(f"Attribute '{name}' of type '{data_type}' not found in Entity '{self.type_name}'"),
            f"the attribute '{name}'",
        )

    def plain_pairs(self, tag: str, first: str, second: str, *, is_typed: bool = False) -> list[Pair] | None:
        """Return two attributes of each child and the line of the child, or None if a child has any other attribute.

        With `is_typed`, the second attribute is converted according to the rules of YAML.
        """
        found: list[Pair] = []
        for child in self._element:
            if child.tag != tag:
                continue
            attributes = child.attrib
            if len(attributes) != 2 or len(child) or first not in attributes or second not in attributes:
                return None
            value = attributes[second]
            found.append((attributes[first], typed(value, None, True) if is_typed else value, getattr(child, 'line', 0)))
        return found or None

    def given(self, attributes: Collection[str], children: Collection[str] = ()) -> list[str]:
        """Return the existing attributes, and then the existing child elements, in the order of the file."""
        self.asked.update(attributes)
        found = [name for name in self._attributes if name in attributes]
        if children:
            self._asked_tags = {*self._asked_tags, *children} if self._asked_tags else children
            if self._element:
                found += dict.fromkeys([child.tag for child in self._element if child.tag in children])
        return found

    @property
    def _known(self) -> Collection[str]:
        return {*self.asked, *self._asked_tags}

    @property
    def _names(self) -> Collection[str]:
        return list(self._attributes)

    def _typed(self, name: str, text: str, data_type: Any, can_be_str: bool) -> Any:
        value: str | list[str] = text
        if len(self._attributes) > 1 and name + SEPARATOR in self._attributes:
            self.asked.add(name + SEPARATOR)
            separator = self._attributes[name + SEPARATOR]
            value = text.split(separator) if separator else [text]
        try:
            return typed(value, data_type, can_be_str)
        except ValueError:
            error = TypeError(
                f"Attribute '{name}' of Entity '{self.type_name}' expected to be of type '{data_type}'. "
                f'`{text}` can not be converted to one of those types'
            )
            raise places.at(error, self) from None

    def assert_entity_completely_parsed(self) -> None:
        """Raise ValueError for child elements that were not requested, and then for attributes that were not requested."""
        asked, asked_tags = self.asked, self._asked_tags
        if self._element and not self._children_asked:
            tags = list(dict.fromkeys([child.tag for child in self._element if child.tag not in asked_tags]))
            if tags:
                instead = 'attribute' if tags[0] in asked else None
                raise self._unexpected('nested tag(s)', tags, instead)
        if not asked.issuperset(self._attributes):
            names = [name for name in self._attributes if name not in asked]
            instead = 'element' if names[0] in asked_tags else None
            raise self._unexpected('attribute(s)', names, instead)
