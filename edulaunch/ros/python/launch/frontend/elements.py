"""The elements of launch: their content, and the action that each creates. The module `launch_ros.launch_extension` contains the
elements of ROS.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from importlib import import_module
from typing import Any

from edulaunch.engine.facts import with_facts

from ..substitution import Substitution
from ..substitutions.text_substitution import TextSubstitution
from . import places
from .condition_of import condition_of
from .entity import Entities, Entity
from .parser_protocol import ParserProtocol

Word = list[Substitution]


def words_of(text: str, parser: ParserProtocol) -> list[Word]:
    """Return the words of a command line. Each word is a list of substitutions.

    Substitutions are found first, and then the literal parts between them are split as in a shell. Text next to a substitution
    stays in one word with the substitution. The value of a substitution is never split. As in upstream, an empty string, and
    blanks before the first substitution, become one empty word.

    :raises ValueError: when a quote is not closed within one literal part.
    """
    words: list[Word] = []
    word: Word = []
    for piece in parser.parse_substitution(text):
        if not isinstance(piece, TextSubstitution):
            word.append(piece)
            continue
        tokens = _split(piece.text)
        if not tokens or (word and piece.text[0].isspace()):
            words.append(word)
            word = []
        for number, token in enumerate(tokens):
            if number:
                words.append(word)
                word = []
            word.append(TextSubstitution(text=token))
        if word and piece.text[-1:].isspace():
            words.append(word)
            word = []
    if word:
        words.append(word)
    return words


def _split(text: str) -> list[str]:
    if '"' not in text and "'" not in text and '\\' not in text:
        return text.split()
    from shlex import split

    try:
        return split(text)
    except ValueError as error:
        raise with_facts(error, 'launch.open-quote', text=text) from None


Parsed = tuple[type, dict[str, Any]]
"""The class (or function) to call, and its keyword arguments."""
Substitutions = list[Substitution]
Reader = Callable[[Entity, ParserProtocol, str], Any]
Attributes = dict[str, tuple[str, Reader]]
"""Name of an attribute or child -> (keyword argument, function that reads it)."""
NOTHING: Attributes = {}


class Element:
    """Parses one kind of element. The class that the element creates is imported when the first such element is parsed.

    :param made_by: the module and name of the class, such as 'launch.actions.log_info.LogInfo'.
    :param needed: the attributes and children that the element must have.
    :param optional: the attributes that the element may have.
    :param children: the child elements that the element may have.
    :param holds_actions: whether all other children are actions.
    """

    def __init__(
        self,
        made_by: str,
        needed: Attributes = NOTHING,
        optional: Attributes = NOTHING,
        children: Attributes = NOTHING,
        *,
        holds_actions: bool = False,
    ) -> None:
        self.module, _, self.class_name = made_by.rpartition('.')
        self.needed = needed
        self.optional = optional
        self.children = children
        self.holds_actions = holds_actions
        self._class: Any = None

    def __call__(self, entity: Entity, parser: ParserProtocol, ignore: Collection[str] = ()) -> Parsed:
        """Return the class and the keyword arguments for the element.

        :param ignore: names of attributes and children that other code parses.
        """
        if self._class is None:
            self._class = getattr(import_module(self.module), self.class_name)
        needed, optional, children = self.needed, self.optional, self.children
        if ignore:
            needed, optional, children = (_without(ignore, attributes) for attributes in (needed, optional, children))
        kwargs = condition_of(entity, parser)
        for name, (keyword, reader) in needed.items():
            kwargs[keyword] = reader(entity, parser, name)
        for name in entity.given(optional, children):
            keyword, reader = optional[name] if name in optional else children[name]
            kwargs[keyword] = reader(entity, parser, name)
        if self.holds_actions:
            kwargs['actions'] = [parser.parse_action(child) for child in entity.children if child.type_name not in children]
        return self._class, kwargs


def _without(ignore: Collection[str], attributes: Attributes) -> Attributes:
    return {name: how for name, how in attributes.items() if name not in ignore}


def text(entity: Entity, parser: ParserProtocol, name: str) -> Substitutions:
    """Return an attribute that is a string with substitutions."""
    return parser.parse_substitution(entity.get_attr(name))


def literal(entity: Entity, parser: ParserProtocol, name: str) -> str:
    """Return an attribute that is a string without substitutions."""
    return parser.escape_characters(entity.get_attr(name))


def typed(data_type: type) -> Reader:
    """Return an attribute of the given type, or a string with substitutions."""
    return lambda entity, parser, name: parser.parse_if_substitutions(entity.get_attr(name, data_type=data_type))


def as_given(data_type: type, *, can_be_str: bool = True) -> Reader:
    """Return an attribute of the given type. As in upstream, substitutions in a string are not evaluated."""
    return lambda entity, parser, name: entity.get_attr(name, data_type=data_type, can_be_str=can_be_str)


def pairs(
    entity: Entity, parser: ParserProtocol, tag: str, first: str = 'name', second: str = 'value'
) -> list[tuple[Substitutions, Substitutions]]:
    """Return child elements such as `<arg name="a" value="b"/>` as pairs, in order."""
    parse = parser.parse_substitution
    plain = entity.plain_pairs(tag, first, second)
    if plain is not None:
        return [(parse(name), parse(value)) for name, value, _ in plain]
    found = []
    for child in entity.get_attr(tag, data_type=Entities):
        found.append((parse(child.get_attr(first)), parse(child.get_attr(second))))
        child.assert_entity_completely_parsed()
    return found


def mapping(entity: Entity, parser: ParserProtocol, tag: str) -> dict[tuple[Substitution, ...], Substitutions]:
    """Return child elements as a dictionary. :func:`pairs` explains the elements."""
    return {tuple(name): value for name, value in pairs(entity, parser, tag)}


def words(entity: Entity, parser: ParserProtocol, name: str) -> list[Substitutions]:
    """Return the words of an attribute that is a command line."""
    return words_of(entity.get_attr(name), parser)


def _choices(entity: Entity, parser: ParserProtocol, name: str) -> list[str]:
    choices = []
    for child in entity.get_attr(name, data_type=Entities):
        choices.append(literal(child, parser, 'value'))
        child.assert_entity_completely_parsed()
    return choices


def _output(entity: Entity, parser: ParserProtocol, name: str) -> Any:
    # A plain string stays a string, so the action can check immediately whether it knows this output.
    return parser.parse_if_substitutions(entity.get_attr(name))


def _on_exit(entity: Entity, parser: ParserProtocol, name: str) -> list[Any]:
    from ..actions.shutdown_action import Shutdown

    value = entity.get_attr(name)
    if value != 'shutdown':
        error = ValueError(
            f'Attribute {name} of Entity node expected to be shutdown but got `{value}`Other on_exit actions not yet supported'
        )
        raise places.at(error, entity, 'launch.only-value', attribute=name, allowed=['shutdown'])
    return [Shutdown()]


def _seconds(entity: Entity, parser: ParserProtocol, name: str) -> float:
    """Return an attribute that is a number of seconds. A string is not allowed, so a substitution is not possible."""
    value: Any = entity.get_attr(name, data_type=float)
    if isinstance(value, str):
        error = TypeError("'<' not supported between instances of 'str' and 'float'")
        raise places.at(error, entity, 'launch.number-only', attribute=name)
    if value < 0.0:
        raise ValueError(f'Attribute {name} of Entity node expected to be a non-negative value but got `{value}`')
    return float(value)


def _seconds_text(entity: Entity, parser: ParserProtocol, name: str) -> str:
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
"""The attributes that every element that starts a program may have."""
PROCESS_CHILDREN: Attributes = {'env': ('additional_env', mapping)}
TIMER: tuple[Attributes, Attributes] = (
    {'period': ('period', typed(float))},
    {'cancel_on_shutdown': ('cancel_on_shutdown', typed(bool))},
)
"""The attributes that every kind of timer must or may have."""
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
