"""The elements of launch: what may stand in them, and the action each makes. `launch_ros.launch_extension` has those of ROS."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import places
from .command_line import words_of
from .element import Attributes, Element, Substitutions, as_given, literal, mapping, pairs, text, typed
from .entity import Entities, Entity

if TYPE_CHECKING:
    from .parser import Parser


def words(entity: Entity, parser: Parser, name: str) -> list[Substitutions]:
    """An attribute that is a command line."""
    return words_of(entity.get_attr(name), parser)


def _choices(entity: Entity, parser: Parser, name: str) -> list[str]:
    choices = []
    for child in entity.get_attr(name, data_type=Entities):
        choices.append(literal(child, parser, 'value'))
        child.assert_entity_completely_parsed()
    return choices


def _output(entity: Entity, parser: Parser, name: str) -> Any:
    # A plain text stays one: the action can tell at once whether it knows such an output.
    return parser.parse_if_substitutions(entity.get_attr(name))


def _on_exit(entity: Entity, parser: Parser, name: str) -> list[Any]:
    from ..actions import Shutdown

    value = entity.get_attr(name)
    if value != 'shutdown':
        error = ValueError(
            f'Attribute {name} of Entity node expected to be shutdown but got `{value}`Other on_exit actions not yet supported'
        )
        raise places.at(error, entity, 'launch.only-value', attribute=name, allowed=['shutdown'])
    return [Shutdown()]


def _seconds(entity: Entity, parser: Parser, name: str) -> float:
    """A number of seconds: no text, so no substitution."""
    value: Any = entity.get_attr(name, data_type=float)
    if isinstance(value, str):
        error = TypeError("'<' not supported between instances of 'str' and 'float'")
        raise places.at(error, entity, 'launch.number-only', attribute=name)
    if value < 0.0:
        raise ValueError(f'Attribute {name} of Entity node expected to be a non-negative value but got `{value}`')
    return float(value)


def _seconds_text(entity: Entity, parser: Parser, name: str) -> str:
    return str(_seconds(entity, parser, name))


PROCESS: Attributes = {
    'cwd': ('cwd', text),
    'name': ('name', text),
    'launch-prefix': ('prefix', text),
    'output': ('output', _output),
    'on_exit': ('on_exit', _on_exit),
    'sigterm_timeout': ('sigterm_timeout', _seconds_text),
    'sigkill_timeout': ('sigkill_timeout', _seconds_text),
    'shell': ('shell', as_given(bool)),
    'emulate_tty': ('emulate_tty', as_given(bool)),
    'respawn': ('respawn', text),
    'respawn_delay': ('respawn_delay', _seconds),
    'respawn_max_retries': ('respawn_max_retries', as_given(int)),
}
"""What every element that starts a program may have."""
PROCESS_CHILDREN: Attributes = {'env': ('additional_env', mapping)}
TIMER: tuple[Attributes, Attributes] = (
    {'period': ('period', typed(float))},
    {'cancel_on_shutdown': ('cancel_on_shutdown', typed(bool))},
)
"""What every kind of timer must, and may, have."""
_NAME: Attributes = {'name': ('name', text)}
_NAME_AND_VALUE: Attributes = {**_NAME, 'value': ('value', text)}
_KEEP: Attributes = {'keep': ('launch_configurations', mapping)}
_BOOLEAN = as_given(bool, can_be_str=False)

ELEMENTS: dict[str, Element] = {
    'arg': Element(
        'launch.actions.declare_launch_argument.DeclareLaunchArgument',
        {'name': ('name', literal)},
        {'default': ('default_value', text), 'description': ('description', literal)},
        {'choice': ('choices', _choices)},
    ),
    'let': Element('launch.actions.set_launch_configuration.SetLaunchConfiguration', _NAME_AND_VALUE),
    'reset': Element('launch.actions.reset_launch_configurations.ResetLaunchConfigurations', children=_KEEP),
    'include': Element(
        'launch.actions.include_launch_description.IncludeLaunchDescription',
        {'file': ('launch_description_source', text)},
        children={'arg': ('launch_arguments', pairs)},
    ),
    'group': Element(
        'launch.actions.group_action.GroupAction',
        optional={'scoped': ('scoped', _BOOLEAN), 'forwarding': ('forwarding', _BOOLEAN)},
        children=_KEEP,
        holds_actions=True,
    ),
    'log': Element('launch.actions.log_info.LogInfo', {'message': ('msg', text)}),
    'set_env': Element('launch.actions.set_environment_variable.SetEnvironmentVariable', _NAME_AND_VALUE),
    'unset_env': Element('launch.actions.unset_environment_variable.UnsetEnvironmentVariable', _NAME),
    'append_env': Element(
        'launch.actions.append_environment_variable.AppendEnvironmentVariable',
        _NAME_AND_VALUE,
        {'prepend': ('prepend', typed(bool)), 'separator': ('separator', text)},
    ),
    'reset_env': Element('launch.actions.reset_environment.ResetEnvironment'),
    'executable': Element('launch.actions.execute_process.ExecuteProcess', {'cmd': ('cmd', words)}, PROCESS, PROCESS_CHILDREN),
    'timer': Element('launch.actions.timer_action.TimerAction', *TIMER, holds_actions=True),
    'shutdown': Element('launch.actions.shutdown_action.Shutdown', optional={'reason': ('reason', text)}),
}
