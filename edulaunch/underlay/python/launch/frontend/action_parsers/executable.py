"""`<executable cmd= ...><env name= value=/></executable>`: a program; nodes have its attributes too."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.actions.execute_process import ExecuteProcess
from launch.actions.shutdown_action import Shutdown

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import Optionals, add_optionals, mapping, text, typed
from .command_line import words_of
from .condition import condition_of


def _output(entity: Entity, parser: Parser, name: str) -> Any:
    # A plain text stays one: the action can tell at once whether it knows such an output.
    return parser.parse_if_substitutions(entity.get_attr(name))


def _on_exit(entity: Entity, parser: Parser, name: str) -> list[Shutdown]:
    value = entity.get_attr(name)
    if value != 'shutdown':
        raise ValueError(
            f"Attribute {name} of Entity {entity.type_name} expected to be 'shutdown' but got '{value}'. "
            'Other on_exit actions not yet supported'
        )
    return [Shutdown()]


PROCESS_OPTIONALS: Optionals = {
    'cwd': ('cwd', text),
    'name': ('name', text),
    'launch-prefix': ('prefix', text),
    'output': ('output', _output),
    'on_exit': ('on_exit', _on_exit),
    'sigterm_timeout': ('sigterm_timeout', text),
    'sigkill_timeout': ('sigkill_timeout', text),
    'shell': ('shell', typed(bool)),
    'emulate_tty': ('emulate_tty', typed(bool)),
    'respawn': ('respawn', typed(bool)),
    'respawn_delay': ('respawn_delay', typed(float)),
    'respawn_max_retries': ('respawn_max_retries', typed(int)),
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
