"""Substitutions: strings that are computed at launch time."""

from typing import TYPE_CHECKING

from .._late import late_names

if TYPE_CHECKING:
    from .anon_name import AnonName as AnonName
    from .boolean_substitution import AllSubstitution as AllSubstitution
    from .boolean_substitution import AndSubstitution as AndSubstitution
    from .boolean_substitution import AnySubstitution as AnySubstitution
    from .boolean_substitution import NotSubstitution as NotSubstitution
    from .boolean_substitution import OrSubstitution as OrSubstitution
    from .command import Command as Command
    from .environment_variable import EnvironmentVariable as EnvironmentVariable
    from .equals_substitution import EqualsSubstitution as EqualsSubstitution
    from .file_content import FileContent as FileContent
    from .find_executable import FindExecutable as FindExecutable
    from .if_else_substitution import IfElseSubstitution as IfElseSubstitution
    from .launch_configuration import LaunchConfiguration as LaunchConfiguration
    from .launch_log_dir import LaunchLogDir as LaunchLogDir
    from .local_substitution import LocalSubstitution as LocalSubstitution
    from .not_equals_substitution import NotEqualsSubstitution as NotEqualsSubstitution
    from .path_join_substitution import PathJoinSubstitution as PathJoinSubstitution
    from .path_substitution import PathSubstitution as PathSubstitution
    from .python_expression import PythonExpression as PythonExpression
    from .string_join_substitution import StringJoinSubstitution as StringJoinSubstitution
    from .substitution_failure import SubstitutionFailure as SubstitutionFailure
    from .text_substitution import TextSubstitution as TextSubstitution
    from .this_launch_file import ThisLaunchFile as ThisLaunchFile
    from .this_launch_file_dir import ThisLaunchFileDir as ThisLaunchFileDir
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
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
        },
    )
