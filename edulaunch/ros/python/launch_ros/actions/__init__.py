"""Actions for ROS: nodes, containers, and settings for the nodes that follow."""

from typing import TYPE_CHECKING

from launch._late import late_names

if TYPE_CHECKING:
    from .composable_node_container import ComposableNodeContainer as ComposableNodeContainer
    from .lifecycle_node import LifecycleNode as LifecycleNode
    from .lifecycle_transition import LifecycleTransition as LifecycleTransition
    from .load_composable_nodes import LoadComposableNodes as LoadComposableNodes
    from .node import Node as Node
    from .push_ros_namespace import PushROSNamespace as PushROSNamespace
    from .push_ros_namespace import PushRosNamespace as PushRosNamespace
    from .ros_timer import ROSTimer as ROSTimer
    from .ros_timer import RosTimer as RosTimer
    from .set_parameter import SetParameter as SetParameter
    from .set_parameters_from_file import SetParametersFromFile as SetParametersFromFile
    from .set_remap import SetRemap as SetRemap
    from .set_ros_log_dir import SetROSLogDir as SetROSLogDir
    from .set_use_sim_time import SetUseSimTime as SetUseSimTime
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
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
        },
    )
