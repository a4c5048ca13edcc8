"""Create the items of a plan. An item is a dictionary that describes one executed action. Groups have no items."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from launch.utilities.texts import perform_substitutions

from edulaunch.advice.plan.process_items import process_item

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

Item = dict[str, Any]
_ADDRESS = re.compile(' at 0x[0-9a-f]+')
SILENT = frozenset(
    ('GroupAction', 'PushLaunchConfigurations', 'PopLaunchConfigurations', 'PushEnvironment', 'PopEnvironment', 'OpaqueFunction')
)


def item_of(action: Any, context: LaunchContext, environ: Mapping[str, str], index: int) -> Item | None:
    """Return the item of an action that was just executed, without its phase. Return None for a group.

    :param action: the action.
    :param context: the launch context.
    :param environ: the environment variables at the start of launch.
    :param index: the number of processes that were started earlier.
    """
    for cls in type(action).__mro__:
        if cls.__module__.partition('.')[0] not in ('launch', 'launch_ros'):
            continue
        if cls.__name__ in SILENT:
            return None
        if cls.__name__ == 'ExecuteLocal':
            return process_item(action, context, environ, index)
        make = _MAKERS.get(cls.__name__)
        if make is not None:
            return make(action, context)
    return {'kind': 'action', 'name': type(action).__name__}


def _text(context: LaunchContext, substitutions: Any) -> str:
    return perform_substitutions(context, substitutions)


def _include(action: Any, context: LaunchContext) -> Item:
    return {'kind': 'include', 'file': os.path.abspath(action.launch_description_source.location)}


def _argument(action: Any, context: LaunchContext) -> Item:
    return {'kind': 'argument', 'name': action.name, 'value': context.launch_configurations.get(action.name)}


def _set_configuration(action: Any, context: LaunchContext) -> Item:
    name = _text(context, action.name)
    return {'kind': 'set_configuration', 'name': name, 'value': context.launch_configurations.get(name)}


def _push_namespace(action: Any, context: LaunchContext) -> Item:
    return {'kind': 'push_namespace', 'namespace': context.launch_configurations.get('ros_namespace')}


def _set_env(action: Any, context: LaunchContext) -> Item:
    name = _text(context, action.name)
    return {'kind': 'set_env', 'name': name, 'value': context.environment.get(name)}


def _timer(action: Any, context: LaunchContext) -> Item:
    from launch.utilities.type_utils import perform_typed_substitution

    return {
        'kind': 'timer',
        'number_of_actions': len(list(action.actions)),
        'period': perform_typed_substitution(context, action.period, float),
    }


def _event_handler(action: Any, context: LaunchContext) -> Item:
    handler = action.event_handler
    description = _ADDRESS.sub(' at 0x', handler.describe()[0])  # without addresses, equal plans are equal strings
    return {'kind': 'event_handler', 'handler': type(handler).__name__, 'description': description}


def _set_parameter(action: Any, context: LaunchContext) -> Item:
    name, value = context.launch_configurations['global_params'][-1]
    return {'kind': 'set_parameter', 'name': name, 'value': list(value) if isinstance(value, tuple) else value}


def _set_remap(action: Any, context: LaunchContext) -> Item:
    source, target = context.launch_configurations['ros_remaps'][-1]
    return {'kind': 'set_remap', 'from': source, 'to': target}


def _load_nodes(action: Any, context: LaunchContext) -> Item:
    from launch_ros.actions.load_composable_nodes import get_composable_node_load_request
    from rclpy.parameter import parameter_value_to_python

    requests = [get_composable_node_load_request(description, context) for description in action.descriptions_to_load]
    nodes = [
        {
            'package': request.package_name,
            'plugin': request.plugin_name,
            'name': request.node_name,
            'namespace': request.node_namespace,
            'remappings': list(request.remap_rules),
            'parameters': {one.name: parameter_value_to_python(one.value) for one in request.parameters},
        }
        for request in requests
        if request is not None
    ]
    return {'kind': 'load_composable_nodes', 'nodes': nodes}


_MAKERS: dict[str, Callable[[Any, LaunchContext], Item]] = {
    'IncludeLaunchDescription': _include,
    'DeclareLaunchArgument': _argument,
    'SetLaunchConfiguration': _set_configuration,
    'PushROSNamespace': _push_namespace,
    'SetEnvironmentVariable': _set_env,
    'AppendEnvironmentVariable': _set_env,
    'UnsetEnvironmentVariable': lambda action, context: {'kind': 'unset_env', 'name': _text(context, action.name)},
    'UnsetLaunchConfiguration': lambda action, context: {'kind': 'unset_configuration', 'name': _text(context, action.name)},
    'ResetLaunchConfigurations': lambda action, context: {
        'kind': 'reset_configurations',
        'kept': dict(context.launch_configurations),
    },
    'ResetEnvironment': lambda action, context: {'kind': 'reset_env'},
    'LogInfo': lambda action, context: {'kind': 'log', 'msg': _text(context, action.msg)},
    'TimerAction': _timer,
    'RegisterEventHandler': _event_handler,
    'Shutdown': lambda action, context: {'kind': 'shutdown'},
    'EmitEvent': lambda action, context: {'kind': 'emit_event', 'event': action.event.name},
    'SetParameter': _set_parameter,
    'SetParametersFromFile': lambda action, context: {
        'kind': 'set_parameters_from_file',
        'file': context.launch_configurations['global_params'][-1],
    },
    'SetRemap': _set_remap,
    'LoadComposableNodes': _load_nodes,
}
