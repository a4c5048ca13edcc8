"""`<group scoped= forwarding=><keep name= value=/>...</group>`: actions with a scope of their own."""
from __future__ import annotations

from launch.actions.group_action import GroupAction

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import mapping
from .condition import condition_of


def parse_group(entity: Entity, parser: Parser) -> Parsed:
    """A group; `scoped` and `forwarding` are plain booleans, without substitutions."""
    kwargs = condition_of(entity, parser)
    for name in ('scoped', 'forwarding'):
        value = entity.get_attr(name, data_type=bool, optional=True, can_be_str=False)
        if value is not None:
            kwargs[name] = value
    kept = mapping(entity, parser, 'keep')
    if kept is not None:
        kwargs['launch_configurations'] = kept
    kwargs['actions'] = [parser.parse_action(child) for child in entity.children if child.type_name != 'keep']
    return GroupAction, kwargs
