"""Functions for launch's own classes and for extensions of launch."""

from typing import TYPE_CHECKING

from .._late import late_names

if TYPE_CHECKING:
    from . import type_utils as type_utils
    from . import typing_file_path as typing_file_path
    from .class_tools_impl import is_a as is_a
    from .class_tools_impl import is_a_subclass as is_a_subclass
    from .class_tools_impl import isclassinstance as isclassinstance
    from .ensure_argument_type_impl import ensure_argument_type as ensure_argument_type
    from .normalize_to_list_of_entities_impl import normalize_to_list_of_entities as normalize_to_list_of_entities
    from .normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions as normalize_to_list_of_substitutions
    from .perform_substitutions_impl import perform_substitutions as perform_substitutions
    from .signal_management import AsyncSafeSignalManager as AsyncSafeSignalManager
    from .visit_all_entities_and_collect_futures_impl import (
        visit_all_entities_and_collect_futures as visit_all_entities_and_collect_futures,
    )
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
            'AsyncSafeSignalManager': 'signal_management',
            'ensure_argument_type': 'ensure_argument_type_impl',
            'is_a': 'class_tools_impl',
            'is_a_subclass': 'class_tools_impl',
            'isclassinstance': 'class_tools_impl',
            'normalize_to_list_of_entities': 'normalize_to_list_of_entities_impl',
            'normalize_to_list_of_substitutions': 'normalize_to_list_of_substitutions_impl',
            'perform_substitutions': 'perform_substitutions_impl',
            'visit_all_entities_and_collect_futures': 'visit_all_entities_and_collect_futures_impl',
        },
        modules=('type_utils',),
        attributes=('typing_file_path',),
    )
