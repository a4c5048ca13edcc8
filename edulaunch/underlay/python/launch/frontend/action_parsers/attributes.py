"""What several elements have in common: optional attributes, and children with a name and a value."""
from __future__ import annotations

from typing import Any

from launch.substitution import Substitution

from ..entity import Entities, Entity
from ..parser import Parser

Substitutions = list[Substitution]


def add_texts(kwargs: dict[str, Any], entity: Entity, parser: Parser, **keywords: str) -> None:
    """For each keyword=attribute that the element has: parse its text into `kwargs`."""
    get_attr = entity.get_attr
    for keyword, attribute in keywords.items():
        text = get_attr(attribute, optional=True)
        if text is not None:
            kwargs[keyword] = parser.parse_substitution(text)


def add_typed(kwargs: dict[str, Any], entity: Entity, parser: Parser, data_type: type, *names: str) -> None:
    """For each attribute of that type (or a text with substitutions) that the element has: into `kwargs`."""
    get_attr = entity.get_attr
    for name in names:
        value = get_attr(name, data_type=data_type, optional=True)
        if value is not None:
            kwargs[name] = parser.parse_if_substitutions(value)


def pairs(entity: Entity, parser: Parser, tag: str, first: str = 'name',
          second: str = 'value') -> list[tuple[Substitutions, Substitutions]] | None:
    """Children like `<env name="A" value="b"/>`, in order; None when there are none."""
    children = entity.get_attr(tag, data_type=Entities, optional=True)
    if children is None:
        return None
    found = []
    for child in children:
        found.append((parser.parse_substitution(child.get_attr(first)),
                      parser.parse_substitution(child.get_attr(second))))
        child.assert_entity_completely_parsed()
    return found


def mapping(entity: Entity, parser: Parser, tag: str) -> dict[tuple[Substitution, ...], Substitutions] | None:
    """The same as :func:`pairs`, as a dictionary."""
    found = pairs(entity, parser, tag)
    return None if found is None else {tuple(name): value for name, value in found}
