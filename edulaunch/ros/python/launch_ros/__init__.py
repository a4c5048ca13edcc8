"""Launch actions for ROS nodes: the interface of ROS 2's launch_ros.

Where this is found, `lifecycle_msgs`, `composition_interfaces` and the other interface packages are too, as in ROS 2, whose
launch_ros depends on them: also when the underlay was put on the path by hand.
"""

from launch._lazy import lazy_exports

from edulaunch.engine.interfaces.importer import installed_registry

_EXPORTS = {
    '': (
        'actions descriptions event_handlers events parameter_descriptions parameters_type remap_rule_type ros_adapters '
        'substitutions utilities'
    ),
    'parameters_type': 'SomeParameters=parameters_type SomeRemapRules=remap_rule_type',
}
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)

if installed_registry() is None:
    from edulaunch.engine.interfaces import install

    install()
