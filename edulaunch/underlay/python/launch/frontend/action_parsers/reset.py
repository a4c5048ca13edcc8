"""`<reset><keep name= value=/></reset>`: forget all launch configurations but some."""
from __future__ import annotations

from launch.actions.reset_launch_configurations import ResetLaunchConfigurations

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import mapping
from .condition import condition_of


def parse_reset(entity: Entity, parser: Parser) -> Parsed:
    """Launch configurations that are cleared."""
    kwargs = condition_of(entity, parser)
    kept = mapping(entity, parser, 'keep')
    if kept is not None:
        kwargs['launch_configurations'] = kept
    return ResetLaunchConfigurations, kwargs
