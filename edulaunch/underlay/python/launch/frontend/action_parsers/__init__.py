"""The built-in elements: one module per element or small group, imported when a launch file uses it.

Each parse function takes (entity, parser) and returns the action's class and its keyword arguments. The class
methods `parse` of the actions lead here too.
"""

from __future__ import annotations

from ..late_parse import LateParse

_ELEMENTS = {
    # element: (module, function)
    'arg': ('arg', 'parse_arg'),
    'let': ('let', 'parse_let'),
    'reset': ('reset', 'parse_reset'),
    'include': ('include', 'parse_include'),
    'group': ('group', 'parse_group'),
    'log': ('log', 'parse_log'),
    'set_env': ('environment', 'parse_set_env'),
    'unset_env': ('environment', 'parse_unset_env'),
    'append_env': ('environment', 'parse_append_env'),
    'reset_env': ('environment', 'parse_reset_env'),
    'executable': ('executable', 'parse_executable'),
    'timer': ('timer', 'parse_timer'),
    'shutdown': ('shutdown', 'parse_shutdown'),
    'node': ('node', 'parse_node'),
    'node_container': ('composition', 'parse_node_container'),
    'load_composable_node': ('composition', 'parse_load_composable_node'),
    'push_ros_namespace': ('namespace', 'parse_push_ros_namespace'),
    'push-ros-namespace': ('namespace', 'parse_push_ros_namespace'),
    'set_parameter': ('ros_settings', 'parse_set_parameter'),
    'set_parameters_from_file': ('ros_settings', 'parse_set_parameters_from_file'),
    'set_remap': ('ros_settings', 'parse_set_remap'),
    'set_use_sim_time': ('ros_settings', 'parse_set_use_sim_time'),
    'set_ros_log_dir': ('ros_settings', 'parse_set_ros_log_dir'),
    'ros_timer': ('ros_timer', 'parse_ros_timer'),
}

BUILT_IN_ACTIONS = {element: LateParse(f'{__name__}.{module}', function) for element, (module, function) in _ELEMENTS.items()}
