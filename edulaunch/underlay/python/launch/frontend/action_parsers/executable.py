"""`<executable cmd= ...><env name= value=/></executable>`: a program; nodes have its attributes too."""
from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.actions.execute_process import ExecuteProcess
from launch.actions.shutdown_action import Shutdown

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import add_texts, add_typed, mapping
from .command_line import words_of
from .condition import condition_of

_TEXTS = {'cwd': 'cwd', 'name': 'name', 'prefix': 'launch-prefix',
          'sigterm_timeout': 'sigterm_timeout', 'sigkill_timeout': 'sigkill_timeout'}
_TYPED: tuple[tuple[type, tuple[str, ...]], ...] = (
    (bool, ('shell', 'emulate_tty', 'respawn')), (float, ('respawn_delay',)), (int, ('respawn_max_retries',)))


def parse_executable(entity: Entity, parser: Parser, ignore: Iterable[str] = ()) -> Parsed:
    """A program with its command line.

    :param ignore: attributes that a subclass reads by itself.
    """
    kwargs: dict[str, Any] = {}
    ignored = frozenset(ignore or ())
    if 'cmd' not in ignored:
        kwargs['cmd'] = words_of(entity.get_attr('cmd'), parser)
    kwargs.update(process_attributes(entity, parser, ignored))
    return ExecuteProcess, kwargs


def process_attributes(entity: Entity, parser: Parser,
                       ignored: frozenset[str] = frozenset()) -> dict[str, Any]:
    """Keyword arguments that every action which starts a program has.

    :raises ValueError: for an `on_exit` other than `shutdown`.
    """
    kwargs = condition_of(entity, parser)
    add_texts(kwargs, entity, parser, **{key: value for key, value in _TEXTS.items() if value not in ignored})
    for data_type, names in _TYPED:
        add_typed(kwargs, entity, parser, data_type, *[name for name in names if name not in ignored])
    if 'output' not in ignored:
        _add_output(kwargs, entity, parser)
    if 'on_exit' not in ignored:
        _add_on_exit(kwargs, entity)
    if 'env' not in ignored:
        environment = mapping(entity, parser, 'env')
        if environment is not None:
            kwargs['additional_env'] = environment
    return kwargs


def _add_output(kwargs: dict[str, Any], entity: Entity, parser: Parser) -> None:
    output = entity.get_attr('output', optional=True)
    if output is not None:
        # A plain text stays one: the action can tell at once whether it knows such an output.
        kwargs['output'] = parser.parse_if_substitutions(output)


def _add_on_exit(kwargs: dict[str, Any], entity: Entity) -> None:
    on_exit = entity.get_attr('on_exit', optional=True)
    if on_exit is None:
        return
    if on_exit != 'shutdown':
        raise ValueError(
            f"Attribute on_exit of Entity {entity.type_name} expected to be 'shutdown' but got '{on_exit}'. "
            'Other on_exit actions not yet supported')
    kwargs['on_exit'] = [Shutdown()]
