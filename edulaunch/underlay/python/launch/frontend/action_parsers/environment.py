"""`<set_env>`, `<unset_env>`, `<append_env>` and `<reset_env>`: environment variables."""

from __future__ import annotations

from typing import Any

from launch.actions.append_environment_variable import AppendEnvironmentVariable
from launch.actions.reset_environment import ResetEnvironment
from launch.actions.set_environment_variable import SetEnvironmentVariable
from launch.actions.unset_environment_variable import UnsetEnvironmentVariable

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import Optionals, add_optionals, text, typed
from .condition import condition_of

_OPTIONALS: Optionals = {'prepend': ('prepend', typed(bool)), 'separator': ('separator', text)}


def parse_set_env(entity: Entity, parser: Parser) -> Parsed:
    """`<set_env name= value=/>`."""
    return SetEnvironmentVariable, _name_and_value(entity, parser)


def parse_unset_env(entity: Entity, parser: Parser) -> Parsed:
    """`<unset_env name=/>`."""
    kwargs = condition_of(entity, parser)
    kwargs['name'] = parser.parse_substitution(entity.get_attr('name'))
    return UnsetEnvironmentVariable, kwargs


def parse_append_env(entity: Entity, parser: Parser) -> Parsed:
    """`<append_env name= value= prepend= separator=/>`."""
    kwargs = _name_and_value(entity, parser)
    add_optionals(kwargs, entity, parser, _OPTIONALS)
    return AppendEnvironmentVariable, kwargs


def parse_reset_env(entity: Entity, parser: Parser) -> Parsed:
    """`<reset_env/>`."""
    return ResetEnvironment, condition_of(entity, parser)


def _name_and_value(entity: Entity, parser: Parser) -> dict[str, Any]:
    kwargs = condition_of(entity, parser)
    kwargs['name'] = parser.parse_substitution(entity.get_attr('name'))
    kwargs['value'] = parser.parse_substitution(entity.get_attr('value'))
    return kwargs
