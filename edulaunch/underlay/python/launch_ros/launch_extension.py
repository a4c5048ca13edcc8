"""What launch_ros adds to XML and YAML launch files, told to launch when it reads the first one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

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
from launch.frontend.entity import Entities, Entity
from launch.frontend.expose import action_parse_methods, substitution_parse_methods
from launch.frontend.substitution_parsers import Keywords, LateSubstitution, takes

from ._param_element import parameters_in

if TYPE_CHECKING:
    from launch.frontend.parser import Parser


def _remappings(entity: Entity, parser: Parser, name: str) -> list[tuple[Substitutions, Substitutions]]:
    return pairs(entity, parser, name, 'from', 'to')


def _extra_arguments(entity: Entity, parser: Parser, name: str) -> list[Any]:
    return [{tuple(key): value} for key, value in pairs(entity, parser, name)]


def _descriptions(entity: Entity, parser: Parser, name: str) -> list[Any]:
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
