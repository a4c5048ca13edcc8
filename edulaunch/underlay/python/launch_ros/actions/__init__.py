"""Actions that know ROS: nodes, containers, and settings for the nodes that follow."""

from launch._lazy import lazy_exports

_EXPORTS = {
    'ComposableNodeContainer': 'composable_node_container',
    'LifecycleNode': 'lifecycle_node',
    'LifecycleTransition': 'lifecycle_transition',
    'LoadComposableNodes': 'load_composable_nodes',
    'Node': 'node',
    'PushROSNamespace': 'push_ros_namespace',
    'PushRosNamespace': 'push_ros_namespace',
    'ROSTimer': 'ros_timer',
    'RosTimer': 'ros_timer',
    'SetParameter': 'set_parameter',
    'SetParametersFromFile': 'set_parameters_from_file',
    'SetROSLogDir': 'set_ros_log_dir',
    'SetRemap': 'set_remap',
    'SetUseSimTime': 'set_use_sim_time',
}
_FILES = {
    'load_composable_nodes': ('composable_node_container',),
    'settings': (
        'push_ros_namespace',
        'set_parameter',
        'set_parameters_from_file',
        'set_remap',
        'set_ros_log_dir',
        'set_use_sim_time',
    ),
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, _FILES)
