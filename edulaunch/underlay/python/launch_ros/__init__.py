"""Launch actions for ROS nodes: the interface of ROS 2's launch_ros."""

from launch._lazy import lazy_exports

_EXPORTS = {
    'actions': '',
    'descriptions': '',
    'event_handlers': '',
    'events': '',
    'parameter_descriptions': '',
    'parameters_type': '',
    'remap_rule_type': '',
    'ros_adapters': '',
    'substitutions': '',
    'utilities': '',
    'SomeParameters': 'parameters_type',
    'SomeRemapRules': 'remap_rule_type',
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
