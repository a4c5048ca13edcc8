"""Settings for all nodes that follow in the scope: parameters, remappings, simulated time, log directory."""

from __future__ import annotations

from typing import Any

from launch_ros.actions.set_parameter import SetParameter
from launch_ros.actions.set_parameters_from_file import SetParametersFromFile
from launch_ros.actions.set_remap import SetRemap
from launch_ros.actions.set_ros_log_dir import SetROSLogDir
from launch_ros.actions.set_use_sim_time import SetUseSimTime

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .condition import condition_of


def parse_set_parameter(entity: Entity, parser: Parser) -> Parsed:
    """`<set_parameter name= value=/>`; the value is always a text, read by YAML's rules at launch time."""
    return SetParameter, _texts(entity, parser, name='name', value='value')


def parse_set_parameters_from_file(entity: Entity, parser: Parser) -> Parsed:
    """`<set_parameters_from_file filename=/>`."""
    return SetParametersFromFile, _texts(entity, parser, filename='filename')


def parse_set_remap(entity: Entity, parser: Parser) -> Parsed:
    """`<set_remap from= to=/>`."""
    return SetRemap, _texts(entity, parser, src='from', dst='to')


def parse_set_ros_log_dir(entity: Entity, parser: Parser) -> Parsed:
    """`<set_ros_log_dir new_log_dir=/>`."""
    return SetROSLogDir, _texts(entity, parser, new_log_dir='new_log_dir')


def parse_set_use_sim_time(entity: Entity, parser: Parser) -> Parsed:
    """`<set_use_sim_time value=/>`."""
    kwargs = condition_of(entity, parser)
    kwargs['value'] = parser.parse_if_substitutions(entity.get_attr('value', data_type=bool))
    return SetUseSimTime, kwargs


def _texts(entity: Entity, parser: Parser, **keywords: str) -> dict[str, Any]:
    """Attributes that are all needed, by keyword argument."""
    kwargs = condition_of(entity, parser)
    for keyword, attribute in keywords.items():
        kwargs[keyword] = parser.parse_substitution(entity.get_attr(attribute))
    return kwargs
