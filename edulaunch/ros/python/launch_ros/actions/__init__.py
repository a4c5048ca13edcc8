"""Actions that know ROS: nodes, containers, and settings for the nodes that follow."""

from launch._lazy import lazy_exports

_EXPORTS = {
    'lifecycle_node': 'LifecycleNode',
    'lifecycle_transition': 'LifecycleTransition',
    'load_composable_nodes': 'ComposableNodeContainer LoadComposableNodes',
    'node': 'Node',
    'ros_timer': 'ROSTimer=ros_timer RosTimer',
    'settings': (
        'PushROSNamespace=push_ros_namespace PushRosNamespace SetParameter SetParametersFromFile SetROSLogDir=set_ros_log_dir '
        'SetRemap SetUseSimTime'
    ),
}
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
