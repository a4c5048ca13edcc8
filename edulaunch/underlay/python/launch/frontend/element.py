"""How an element of a launch file becomes the keyword arguments of an action."""

from __future__ import annotations

from collections.abc import Callable, Collection
from importlib import import_module
from typing import TYPE_CHECKING, Any

from ..substitution import Substitution
from .entity import Entities, Entity

if TYPE_CHECKING:
    from .parser import Parser

Parsed = tuple[type, dict[str, Any]]
"""What to make: a class (or function) and its keyword arguments."""
Substitutions = list[Substitution]
Reader = Callable[[Entity, 'Parser', str], Any]
Attributes = dict[str, tuple[str, Reader]]
"""Name of an attribute or child -> (keyword argument, how it is read)."""
NOTHING: Attributes = {}


class Element:
    """Reads one kind of element; the class it makes is imported when the first one is read.

    :param made_by: module and class, such as 'launch.actions.log_info.LogInfo'.
    :param needed: attributes and children that it must have.
    :param optional: attributes that it may have.
    :param children: child elements that it may have.
    :param holds_actions: all other children are actions.
    """

    def __init__(
        self,
        made_by: str,
        needed: Attributes = NOTHING,
        optional: Attributes = NOTHING,
        children: Attributes = NOTHING,
        *,
        holds_actions: bool = False,
    ) -> None:
        self.module, _, self.class_name = made_by.rpartition('.')
        self.needed = needed
        self.optional = optional
        self.children = children
        self.holds_actions = holds_actions
        self._class: Any = None

    def __call__(self, entity: Entity, parser: Parser, ignore: Collection[str] = ()) -> Parsed:
        """The class, and its keyword arguments.

        :param ignore: attributes and children that somebody else reads.
        """
        if self._class is None:
            self._class = getattr(import_module(self.module), self.class_name)
        needed, optional, children = self.needed, self.optional, self.children
        if ignore:
            needed, optional, children = (_without(ignore, attributes) for attributes in (needed, optional, children))
        kwargs = condition_of(entity, parser)
        for name, (keyword, reader) in needed.items():
            kwargs[keyword] = reader(entity, parser, name)
        for name in entity.given(optional, children):
            keyword, reader = optional[name] if name in optional else children[name]
            kwargs[keyword] = reader(entity, parser, name)
        if self.holds_actions:
            kwargs['actions'] = [parser.parse_action(child) for child in entity.children if child.type_name not in children]
        return self._class, kwargs


def _without(ignore: Collection[str], attributes: Attributes) -> Attributes:
    return {name: how for name, how in attributes.items() if name not in ignore}


def condition_of(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Keyword argument `condition`, when the element has `if` or `unless`.

    :raises RuntimeError: when it has both.
    """
    given = entity.given(('if', 'unless'))
    if not given:
        return {}
    if len(given) > 1:
        raise RuntimeError("if and unless conditions can't be used simultaneously")
    from .. import conditions

    (name,) = given
    condition = conditions.IfCondition if name == 'if' else conditions.UnlessCondition
    return {'condition': condition(predicate_expression=parser.parse_substitution(entity.get_attr(name)))}


def text(entity: Entity, parser: Parser, name: str) -> Substitutions:
    """An attribute that is a text with substitutions."""
    return parser.parse_substitution(entity.get_attr(name))


def literal(entity: Entity, parser: Parser, name: str) -> str:
    """An attribute that is a text without substitutions."""
    return parser.escape_characters(entity.get_attr(name))


def typed(data_type: type) -> Reader:
    """An attribute of that type, or a text with substitutions."""
    return lambda entity, parser, name: parser.parse_if_substitutions(entity.get_attr(name, data_type=data_type))


def as_given(data_type: type, *, can_be_str: bool = True) -> Reader:
    """An attribute of that type; upstream looks for no substitutions in a text there."""
    return lambda entity, parser, name: entity.get_attr(name, data_type=data_type, can_be_str=can_be_str)


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
