"""What the actions here are built with."""

from launch._lazy import lazy_exports

_EXPORTS = {
    'names': (
        'add_node_name=track_node_names get_node_name_count=track_node_names is_namespace_absolute=namespace_utils '
        'is_root_namespace=namespace_utils make_namespace_absolute=namespace_utils normalize_remap_rule '
        'normalize_remap_rules=normalize_remap_rule prefix_namespace=namespace_utils'
    ),
    'parameters': (
        'evaluate_parameter_dict=evaluate_parameters evaluate_parameters normalize_parameter_dict=normalize_parameters '
        'normalize_parameters'
    ),
    'to_parameters_list': 'to_parameters_list',
}
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
