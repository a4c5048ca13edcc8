"""`<group scoped= forwarding=><keep name= value=/>...</group>`: actions with a scope of their own."""

from __future__ import annotations

from launch.actions.group_action import GroupAction

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import Optionals, add_optionals, mapping
from .condition import condition_of


def _boolean(entity: Entity, parser: Parser, name: str) -> bool:
    value: bool = entity.get_attr(name, data_type=bool, can_be_str=False)
    return value


_OPTIONALS: Optionals = {'scoped': ('scoped', _boolean), 'forwarding': ('forwarding', _boolean)}
_CHILDREN: Optionals = {'keep': ('launch_configurations', mapping)}


def parse_group(entity: Entity, parser: Parser) -> Parsed:
    """A group; `scoped` and `forwarding` are plain booleans, without substitutions."""
    kwargs = condition_of(entity, parser)
    add_optionals(kwargs, entity, parser, _OPTIONALS, _CHILDREN)
    kwargs['actions'] = [parser.parse_action(child) for child in entity.children if child.type_name != 'keep']
    return GroupAction, kwargs
