"""Substitutions: texts that are found out at launch time."""

from .._lazy import lazy_exports

_EXPORTS = {
    'AllSubstitution': 'boolean_substitution',
    'AndSubstitution': 'boolean_substitution',
    'AnonName': 'anon_name',
    'AnySubstitution': 'boolean_substitution',
    'Command': 'command',
    'EnvironmentVariable': 'environment_variable',
    'EqualsSubstitution': 'equals_substitution',
    'FileContent': 'file_content',
    'FindExecutable': 'find_executable',
    'IfElseSubstitution': 'if_else_substitution',
    'LaunchConfiguration': 'launch_configuration',
    'LaunchLogDir': 'launch_log_dir',
    'LocalSubstitution': 'local_substitution',
    'NotEqualsSubstitution': 'not_equals_substitution',
    'NotSubstitution': 'boolean_substitution',
    'OrSubstitution': 'boolean_substitution',
    'PathJoinSubstitution': 'path_join_substitution',
    'PathSubstitution': 'path_substitution',
    'PythonExpression': 'python_expression',
    'StringJoinSubstitution': 'string_join_substitution',
    'SubstitutionFailure': 'substitution_failure',
    'TextSubstitution': 'text_substitution',
    'ThisLaunchFile': 'this_launch_file',
    'ThisLaunchFileDir': 'this_launch_file_dir',
}
_FILES = {
    'booleans': ('boolean_substitution', 'equals_substitution', 'if_else_substitution', 'not_equals_substitution'),
    'evaluated': ('command', 'python_expression'),
    'paths': (
        'file_content',
        'find_executable',
        'launch_log_dir',
        'path_join_substitution',
        'path_substitution',
        'string_join_substitution',
        'this_launch_file',
        'this_launch_file_dir',
    ),
    'text_substitution': ('substitution_failure',),
    'values': ('anon_name', 'environment_variable', 'launch_configuration', 'local_substitution'),
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS, _FILES)
