"""What launch's own classes, and extensions of launch, are built with."""

from .._lazy import lazy_exports

_EXPORTS = {
    '': 'type_utils',
    'entities': (
        'normalize_to_list_of_entities=normalize_to_list_of_entities_impl '
        'visit_all_entities_and_collect_futures=visit_all_entities_and_collect_futures_impl'
    ),
    'signal_management': 'AsyncSafeSignalManager=signal_management',
    'texts': (
        'normalize_to_list_of_substitutions=normalize_to_list_of_substitutions_impl '
        'perform_substitutions=perform_substitutions_impl'
    ),
    'type_utils': (
        'ensure_argument_type=ensure_argument_type_impl is_a=class_tools_impl is_a_subclass=class_tools_impl '
        'isclassinstance=class_tools_impl =typing_file_path'
    ),
}
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
