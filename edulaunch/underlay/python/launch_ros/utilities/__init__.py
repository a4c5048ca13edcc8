"""What the actions here are built with."""

from launch._lazy import lazy_exports

_EXPORTS = {
    'add_node_name': 'track_node_names',
    'evaluate_parameter_dict': 'evaluate_parameters',
    'evaluate_parameters': 'evaluate_parameters',
    'get_node_name_count': 'track_node_names',
    'is_namespace_absolute': 'namespace_utils',
    'is_root_namespace': 'namespace_utils',
    'make_namespace_absolute': 'namespace_utils',
    'normalize_parameter_dict': 'normalize_parameters',
    'normalize_parameters': 'normalize_parameters',
    'normalize_remap_rule': 'normalize_remap_rule',
    'normalize_remap_rules': 'normalize_remap_rule',
    'prefix_namespace': 'namespace_utils',
    'to_parameters_list': 'to_parameters_list',
}
_FILES = {
    'names': ('namespace_utils', 'normalize_remap_rule', 'track_node_names'),
    'parameters': ('evaluate_parameters', 'normalize_parameters'),
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, _FILES)
