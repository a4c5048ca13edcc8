"""A YAML value as the parse functions receive it."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from launch.frontend import places
from launch.frontend.entity import Entities, Pair, check_is_list_entity
from launch.frontend.entity import Entity as BaseEntity
from launch.frontend.expose import action_parse_methods
from launch.utilities.type_utils import is_instance_of

_SCALARS = frozenset((str, int, float, bool))


class Entity(BaseEntity):
    """The value below the name of an element.

    :param element: a mapping of attributes, or directly the list of child elements.
    :param type_name: the name of the element.
    :param parent: the enclosing element, or None.
    """

    __slots__ = ('_element', '_type_name', '_parent', '_line', '_children_asked')

    def __init__(self, element: Any, type_name: str | None = None, *, parent: Entity | None = None, line: int = 0) -> None:
        self._element = element
        self._type_name = type_name
        self._parent = parent
        self._line = line
        self._children_asked = False
        self.asked: set[str] = set()

    @property
    def type_name(self) -> str:
        return self._type_name  # type: ignore[return-value]

    @property
    def parent(self) -> Entity | None:
        return self._parent

    @property
    def line(self) -> int:
        return self._line

    @property
    def children(self) -> list[BaseEntity]:
        """The elements in the list, or in the list under the key `children`.

        :raises TypeError: when the children are not a list.
        :raises ValueError: when the element has no children.
        :raises RuntimeError: when an item of the list is not a mapping with one key.
        """
        self._children_asked = True
        return [self._child(item) for item in self._list_of_children()]

    def _list_of_children(self) -> list[Any]:
        children = self._element
        if isinstance(children, dict):
            if 'children' not in children:
                error = ValueError(
                    f'Expected entity `{self._type_name}` to have children entities. '
                    'That can be a list of subentities or a dictionary with a `children` list element'
                )
                inside = next((key for key in children if key in action_parse_methods), None)
                raise places.at(error, self, 'launch.yaml-children', first_element=inside)
            self.asked.add('children')
            children = children['children']
        if not isinstance(children, list):
            no_list = TypeError(f"Expected a list of child entities in '{self._type_name}', got '{_type_of(children)}'")
            raise places.at(no_list, self, 'launch.yaml-list')
        return children

    def _child(self, item: Any) -> Entity:
        if not isinstance(item, dict) or len(item) != 1:
            raise self._no_single_element(item)
        ((type_name, element),) = item.items()
        return Entity(element, type_name, parent=self, line=getattr(item, 'line', 0))

    def _no_single_element(self, item: Any) -> RuntimeError:
        """Return the error for an item of the list of children that does not contain exactly one element."""
        error = RuntimeError('Subentities must be a dictionary with only one key, which is the entity type')
        if not isinstance(item, dict) or not item:
            return places.at(error, self, 'launch.yaml-item')
        first, *rest = map(str, item)
        is_empty = next(iter(item.values())) is None  # the content of the element is in the same column as its name
        below = rest if is_empty else None
        opened = first if is_empty else None
        places.at(error, self, 'launch.yaml-item', several=[first, *rest], opened=opened, below=below)
        error.edulaunch_line = getattr(item, 'line', self.line)  # type: ignore[attr-defined]
        return error

    def get_attr(self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True) -> Any:
        """Return the value under the key `name`, converted to the data type. For `List[Entity]`, return child elements."""
        self.asked.add(name)
        element = self._element
        if not isinstance(element, dict) or name not in element:
            if optional:
                return None
            missing = AttributeError(f"Can not find attribute '{name}' in Entity '{self._type_name}'")
            if isinstance(element, list):
                raise places.at(missing, self, 'launch.yaml-dashes', key=name)
            if isinstance(element, (str, int, float)):
                raise places.at(missing, self, 'launch.yaml-bare', key=name, value=str(element))
            raise self._missing(missing, f"the key '{name}'")
        value = element[name]
        if type(value) is data_type or (data_type is None and type(value) in _SCALARS):
            return value
        if data_type is Entities or (data_type is not str and check_is_list_entity(data_type)):
            return self._entities(name, value)
        if not is_instance_of(value, data_type, can_be_str=can_be_str):
            error = TypeError(
                f"Attribute '{name}' of Entity '{self._type_name}' expected to be of type '{data_type}', got '{_type_of(value)}'"
            )
            raise places.at(error, self, 'launch.yaml-type', key=name, write=_as_wanted(value, data_type))
        return value

    def plain_pairs(self, tag: str, first: str, second: str, *, is_typed: bool = False) -> list[Pair] | None:
        """Return the values of two keys of each child and the line of the child.

        Return None if a child has any other key, or if the types do not match.
        """
        element = self._element
        children = element.get(tag) if isinstance(element, dict) else None
        if not isinstance(children, list) or not children:
            return None
        found: list[Pair] = []
        for child in children:
            if not isinstance(child, dict) or len(child) != 2 or first not in child or second not in child:
                return None
            name, value = child[first], child[second]
            if type(name) is not str or (type(value) not in _SCALARS if is_typed else type(value) is not str):
                return None
            found.append((name, value, getattr(child, 'line', self._line)))
        self.asked.add(tag)
        return found

    def given(self, attributes: Collection[str], children: Collection[str] = ()) -> list[str]:
        """Return the existing keys, in the order of the file."""
        self.asked.update(attributes, children)
        element = self._element
        return [name for name in element if name in attributes or name in children] if isinstance(element, dict) else []

    @property
    def _names(self) -> Collection[str]:
        return list(self._element) if isinstance(self._element, dict) else ()

    def _entities(self, name: str, value: Any) -> list[Entity]:
        if not isinstance(value, list) or not value or not all(isinstance(item, dict) for item in value):
            error = TypeError(f"Attribute '{name}' of Entity '{self._type_name}' expected to be a list of dictionaries.")
            raise places.at(error, self, 'launch.yaml-list-of', key=name)
        line = self._line
        return [Entity(item, name, parent=self, line=getattr(item, 'line', line)) for item in value]

    def assert_entity_completely_parsed(self) -> None:
        """Raise ValueError for keys that were not requested, or for a list of child elements that was not requested.

        :raises TypeError: when the element has no value, not even an empty mapping. As in upstream, Python raises this error.
        """
        element = self._element
        if element is None:
            raise places.at(TypeError("argument of type 'NoneType' is not iterable"), self, 'launch.yaml-nothing')
        if isinstance(element, dict):
            keys = [key for key in element if key not in self.asked]
            if keys:
                raise self._unexpected('key(s)', keys)
        elif element and not self._children_asked:
            raise ValueError(f'Unexpected nested entity(ies) found in `{self._type_name}`: {element}')


def _as_wanted(value: Any, data_type: Any) -> str | None:
    """Return an explanation of how to write a value of that type, or None."""
    if data_type is str and isinstance(value, (int, float)):
        return f"'{str(value).lower() if isinstance(value, bool) else value}'"
    if data_type is str and isinstance(value, list) and all(isinstance(item, str) for item in value):
        return f"'{' '.join(value)}'"
    if data_type is float and type(value) is int:
        return f'{value}.0'
    return 'true' if data_type is bool else None


def _type_of(value: Any) -> type:
    """Return the name of the value's type as errors show it. For a mapping that stores its line, the name is `dict`."""
    return dict if isinstance(value, dict) else type(value)
