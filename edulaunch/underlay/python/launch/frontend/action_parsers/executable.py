"""`<executable cmd= ...><env name= value=/></executable>`: a program; nodes have its attributes too."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.actions.execute_process import ExecuteProcess
from launch.actions.shutdown_action import Shutdown

from .. import hints
from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import Optionals, Reader, add_optionals, mapping, text
from .command_line import words_of
from .condition import condition_of


def _output(entity: Entity, parser: Parser, name: str) -> Any:
    # A plain text stays one: the action can tell at once whether it knows such an output.
    return parser.parse_if_substitutions(entity.get_attr(name))


def _on_exit(entity: Entity, parser: Parser, name: str) -> list[Shutdown]:
    value = entity.get_attr(name)
    if value != 'shutdown':
        error = ValueError(
            f'Attribute {name} of Entity node expected to be shutdown but got `{value}`Other on_exit actions not yet supported'
        )
        raise hints.at(error, entity, f"{name} can only be 'shutdown'")
    return [Shutdown()]


def _as_given(data_type: type) -> Reader:
    """An attribute of that type; upstream looks for no substitutions in a text there."""
    return lambda entity, parser, name: entity.get_attr(name, data_type=data_type)


def _seconds(entity: Entity, parser: Parser, name: str) -> float:
    """A number of seconds: no text, so no substitution."""
    value: Any = entity.get_attr(name, data_type=float)
    if isinstance(value, str):
        error = TypeError("'<' not supported between instances of 'str' and 'float'")
        raise hints.at(error, entity, f"'{name}' is a number in ROS 2; a $(...) is not evaluated here")
    if value < 0.0:
        raise ValueError(f'Attribute {name} of Entity node expected to be a non-negative value but got `{value}`')
    return float(value)


def _seconds_text(entity: Entity, parser: Parser, name: str) -> str:
    return str(_seconds(entity, parser, name))


PROCESS_OPTIONALS: Optionals = {
    'cwd': ('cwd', text),
    'name': ('name', text),
    'launch-prefix': ('prefix', text),
    'output': ('output', _output),
    'on_exit': ('on_exit', _on_exit),
    'sigterm_timeout': ('sigterm_timeout', _seconds_text),
    'sigkill_timeout': ('sigkill_timeout', _seconds_text),
    'shell': ('shell', _as_given(bool)),
    'emulate_tty': ('emulate_tty', _as_given(bool)),
    'respawn': ('respawn', text),
    'respawn_delay': ('respawn_delay', _seconds),
    'respawn_max_retries': ('respawn_max_retries', _as_given(int)),
}
PROCESS_CHILDREN: Optionals = {'env': ('additional_env', mapping)}
"""What every element that starts a program may have."""


def parse_executable(entity: Entity, parser: Parser, ignore: Iterable[str] | None = None) -> Parsed:
    """A program with its command line.

    :param ignore: attributes that a subclass reads by itself.
    """
    kwargs = condition_of(entity, parser)
    ignored = frozenset(ignore or ())
    if 'cmd' not in ignored:
        kwargs['cmd'] = words_of(entity.get_attr('cmd'), parser)
    attributes, children = (
        {name: how for name, how in optionals.items() if name not in ignored}
        for optionals in (PROCESS_OPTIONALS, PROCESS_CHILDREN)
    )
    add_optionals(kwargs, entity, parser, attributes, children)
    return ExecuteProcess, kwargs
