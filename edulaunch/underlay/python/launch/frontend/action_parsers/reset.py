"""`<reset><keep name= value=/></reset>`: forget all launch configurations but some."""

from __future__ import annotations

from launch.actions.reset_launch_configurations import ResetLaunchConfigurations

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import NOTHING, Optionals, add_optionals, mapping
from .condition import condition_of

_CHILDREN: Optionals = {'keep': ('launch_configurations', mapping)}


def parse_reset(entity: Entity, parser: Parser) -> Parsed:
    """Launch configurations that are cleared."""
    kwargs = condition_of(entity, parser)
    add_optionals(kwargs, entity, parser, NOTHING, _CHILDREN)
    return ResetLaunchConfigurations, kwargs
