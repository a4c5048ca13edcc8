"""What elements have in common: optional attributes, and children with a name and a value."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from launch.substitution import Substitution

from ..entity import Entities, Entity
from ..parser import Parser

Substitutions = list[Substitution]
Reader = Callable[[Entity, Parser, str], Any]
Optionals = dict[str, tuple[str, Reader]]
"""What an element may have: name of the attribute or child -> (keyword argument, how it is read)."""
NOTHING: Optionals = {}


def add_optionals(
    kwargs: dict[str, Any], entity: Entity, parser: Parser, attributes: Optionals, children: Optionals = NOTHING
) -> None:
    """Read those of the optional `attributes` and `children` that the element has into `kwargs`."""
    for name in entity.given(attributes, children):
        keyword, reader = attributes[name] if name in attributes else children[name]
        kwargs[keyword] = reader(entity, parser, name)


def text(entity: Entity, parser: Parser, name: str) -> Substitutions:
    """An attribute that is a text with substitutions."""
    return parser.parse_substitution(entity.get_attr(name))


def typed(data_type: type) -> Reader:
    """An attribute of that type, or a text with substitutions."""

    def read(entity: Entity, parser: Parser, name: str) -> Any:
        return parser.parse_if_substitutions(entity.get_attr(name, data_type=data_type))

    return read


def pairs(
    entity: Entity, parser: Parser, tag: str, first: str = 'name', second: str = 'value'
) -> list[tuple[Substitutions, Substitutions]]:
    """Children like `<arg name="a" value="b"/>`, in order."""
    parse = parser.parse_substitution
    plain = entity.plain_pairs(tag, first, second)
    if plain is not None:
        return [(parse(name), parse(value)) for name, value, _ in plain]
    found = []
    for child in entity.get_attr(tag, data_type=Entities):
        found.append((parse(child.get_attr(first)), parse(child.get_attr(second))))
        child.assert_entity_completely_parsed()
    return found


def mapping(entity: Entity, parser: Parser, tag: str) -> dict[tuple[Substitution, ...], Substitutions]:
    """The same as :func:`pairs`, as a dictionary."""
    return {tuple(name): value for name, value in pairs(entity, parser, tag)}
