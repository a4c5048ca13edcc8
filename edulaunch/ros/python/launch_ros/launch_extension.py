"""The elements and substitutions that launch_ros adds to XML and YAML launch files.

Launch registers them when it reads the first such file.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.frontend import places
from launch.frontend.elements import (
    PROCESS,
    PROCESS_CHILDREN,
    TIMER,
    Attributes,
    Element,
    Substitutions,
    pairs,
    text,
    typed,
    words,
)
from launch.frontend.entity import Entities, Entity, Pair
from launch.frontend.expose import action_parse_methods, substitution_parse_methods
from launch.frontend.substitution_parsers import Keywords, LateSubstitution, takes
from launch.utilities.type_utils import ListTypesTuple, ScalarTypesTuple

from .parameter_descriptions import ParameterFile, ParameterValue

if TYPE_CHECKING:
    from launch.frontend.parser_protocol import ParserProtocol

_SCALARS = ('int', 'float', 'bool', 'str')
_TYPES: dict[str, Any] = {
    **dict(zip(_SCALARS, ScalarTypesTuple, strict=True)),
    **{f'list_of_{name}': data_type for name, data_type in zip(_SCALARS, ListTypesTuple, strict=True)},
    'yaml': None,
}
_WHICH = frozenset(('name', 'from', 'allow_substs'))
_WHAT = frozenset(('value', 'type'))
_INSIDE = frozenset(('param',))


def parameters_in(entity: Entity, parser: ParserProtocol, tag: str) -> list[Any]:
    """Return the argument `parameters` of a node, with one source for each element. The sources have the order of the file, so
    later sources override earlier sources.

    :raises RuntimeError: for attributes that cannot be combined.
    :raises ValueError: for an element with neither `name` nor `from`.
    """
    plain = entity.plain_pairs(tag, 'name', 'value', is_typed=True)
    if plain is not None:
        return [_plain_dictionary([pair], parser) for pair in plain]
    parameters: list[Any] = []
    for param in entity.get_attr(tag, data_type=Entities):
        given = param.given(_WHICH)
        if 'from' in given:
            parameters.append(_file(param, given, parser))
        elif 'allow_substs' in given:
            raise _wrong(param, "'allow_substs' can only be used together with 'from' attribute")
        elif 'name' in given:
            parameters.append(_dictionary([param], parser))
        else:
            raise places.at(ValueError('param Entity should have name or from attribute'), param, 'launch.param-element')
    return parameters


def _file(param: Entity, given: list[str], parser: ParserProtocol) -> ParameterFile:
    if 'name' in given:
        raise _wrong(param, 'name and from attributes are mutually exclusive', one='name', other='from')
    param.assert_entity_completely_parsed()
    path = parser.parse_substitution(param.get_attr('from'))
    allow_substs = param.get_attr('allow_substs', data_type=bool) if 'allow_substs' in given else False
    return ParameterFile(path, allow_substs=parser.parse_if_substitutions(allow_substs))


def _plain_dictionary(pairs: list[Pair], parser: ParserProtocol) -> dict[Any, Any]:
    parse, parse_typed = parser.parse_substitution, parser.parse_if_substitutions
    return {tuple(parse(name)): _made(line, parse_typed(value), None) for name, value, line in pairs}


def _dictionary(params: list[Entity], parser: ParserProtocol) -> dict[Any, Any]:
    return {tuple(parser.parse_substitution(param.get_attr('name'))): _value(param, parser) for param in params}


def _made(line: int, value: Any, data_type: Any) -> ParameterValue:
    made = ParameterValue(value, value_type=data_type)
    made.line = line
    return made


def _value(param: Entity, parser: ParserProtocol) -> Any:
    given = param.given(_WHAT, _INSIDE)
    data_type = _data_type(param) if 'type' in given else None
    if 'param' in given:
        for name in ('value', 'type'):
            if name in given:
                text = f'nested parameters and {name} attributes are mutually exclusive'
                raise _wrong(param, text, one=name, other=f'a nested {param.shown}')
        param.assert_entity_completely_parsed()
        plain = param.plain_pairs('param', 'name', 'value', is_typed=True)
        if plain is not None:
            return _plain_dictionary(plain, parser)
        return _dictionary(param.get_attr('param', data_type=Entities), parser)
    if 'value' not in given:
        error = RuntimeError('either a value attribute or nested params are needed')
        raise places.at(error, param, 'launch.missing-attribute', needed='value', given_names=[])
    value = parser.parse_if_substitutions(param.get_attr('value', data_type=data_type))
    param.assert_entity_completely_parsed()
    return _made(param.line, value, data_type)


def _data_type(param: Entity) -> Any:
    name = param.get_attr('type')
    if name not in _TYPES:
        error = ValueError(f'Got invalid type identifier {name!r}')
        raise places.at(error, param, 'launch.only-value', attribute='type', allowed=list(_TYPES))
    return _TYPES[name]


def _wrong(param: Entity, message: str, **facts: str) -> RuntimeError:
    return places.at(RuntimeError(message), param, **facts)


def _remappings(entity: Entity, parser: ParserProtocol, name: str) -> list[tuple[Substitutions, Substitutions]]:
    return pairs(entity, parser, name, 'from', 'to')


def _extra_arguments(entity: Entity, parser: ParserProtocol, name: str) -> list[Any]:
    return [{tuple(key): value} for key, value in pairs(entity, parser, name)]


def _descriptions(entity: Entity, parser: ParserProtocol, name: str) -> list[Any]:
    descriptions = []
    for child in entity.get_attr(name, data_type=Entities):
        made_by, kwargs = _COMPOSABLE_NODE(child, parser)
        child.assert_entity_completely_parsed()
        descriptions.append(made_by(**kwargs))
    return descriptions


_NODE_CHILDREN: Attributes = {'remap': ('remappings', _remappings), 'param': ('parameters', parameters_in)}
_NODE: tuple[Attributes, Attributes, Attributes] = (
    {'exec': ('executable', text)},
    {
        **PROCESS,
        'pkg': ('package', text),
        'namespace': ('namespace', text),
        'exec_name': ('exec_name', text),
        'args': ('arguments', words),
        'ros_args': ('ros_arguments', words),
    },
    {**PROCESS_CHILDREN, **_NODE_CHILDREN},
)


_NAMESPACE: Attributes = {'namespace': ('namespace', text)}
_COMPOSABLE_NODES: Attributes = {'composable_node': ('composable_node_descriptions', _descriptions)}
_COMPOSABLE_NODE = Element(
    'launch_ros.descriptions.composable_node.ComposableNode',
    {'pkg': ('package', text), 'plugin': ('plugin', text), 'name': ('name', text)},
    _NAMESPACE,
    {**_NODE_CHILDREN, 'extra_arg': ('extra_arguments', _extra_arguments)},
)


_PUSH_NAMESPACE = Element('launch_ros.actions.push_ros_namespace.PushROSNamespace', _NAMESPACE)
ELEMENTS: dict[str, Element] = {
    'node': Element('launch_ros.actions.node.Node', *_NODE),
    'node_container': Element(
        'launch_ros.actions.composable_node_container.ComposableNodeContainer', *_NODE[:2], {**_NODE[2], **_COMPOSABLE_NODES}
    ),
    'load_composable_node': Element(
        'launch_ros.actions.load_composable_nodes.LoadComposableNodes',
        {'target': ('target_container', text), **_COMPOSABLE_NODES},
    ),
    'push_ros_namespace': _PUSH_NAMESPACE,
    'push-ros-namespace': _PUSH_NAMESPACE,
    'set_parameter': Element('launch_ros.actions.set_parameter.SetParameter', {'name': ('name', text), 'value': ('value', text)}),
    'set_parameters_from_file': Element(
        'launch_ros.actions.set_parameters_from_file.SetParametersFromFile', {'filename': ('filename', text)}
    ),
    'set_remap': Element('launch_ros.actions.set_remap.SetRemap', {'from': ('src', text), 'to': ('dst', text)}),
    'set_use_sim_time': Element('launch_ros.actions.set_use_sim_time.SetUseSimTime', {'value': ('value', typed(bool))}),
    'set_ros_log_dir': Element('launch_ros.actions.set_ros_log_dir.SetROSLogDir', {'new_log_dir': ('new_log_dir', text)}),
    'ros_timer': Element('launch_ros.actions.ros_timer.ROSTimer', *TIMER, holds_actions=True),
}


def _makes(class_name: str, module: str, keywords: Keywords) -> LateSubstitution:
    return LateSubstitution(f'launch_ros.substitutions.{module}', class_name, keywords)


SUBSTITUTIONS = {
    'find-pkg-share': _makes(
        'FindPackageShare',
        'find_package',
        takes('find-pkg-share substitution expects 1 argument', 1, 'package', error=AttributeError),
    ),
    'find-pkg-prefix': _makes(
        'FindPackagePrefix',
        'find_package',
        takes('find-pkg-prefix substitution expects 1 argument', 1, 'package', error=AttributeError),
    ),
    'exec-in-pkg': _makes(
        'ExecutableInPackage',
        'executable_in_package',
        takes('exec-in-pkg substitution expects 2 arguments', 2, 'executable', 'package', error=AttributeError),
    ),
    'param': _makes('Parameter', 'parameter', takes('param substitution expects 1 or 2 arguments', 1, 'name', 'default')),
}


action_parse_methods.update(ELEMENTS)


substitution_parse_methods.update(SUBSTITUTIONS)
