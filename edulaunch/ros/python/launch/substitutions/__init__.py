"""Substitutions: texts that are found out at launch time."""

from .._lazy import lazy_exports

_EXPORTS = {
    'booleans': (
        'AllSubstitution=boolean_substitution AndSubstitution=boolean_substitution AnySubstitution=boolean_substitution '
        'EqualsSubstitution IfElseSubstitution NotEqualsSubstitution NotSubstitution=boolean_substitution '
        'OrSubstitution=boolean_substitution'
    ),
    'evaluated': 'Command PythonExpression',
    'paths': (
        'FileContent FindExecutable LaunchLogDir PathJoinSubstitution PathSubstitution StringJoinSubstitution ThisLaunchFile '
        'ThisLaunchFileDir'
    ),
    'text_substitution': 'SubstitutionFailure TextSubstitution',
    'values': 'AnonName EnvironmentVariable LaunchConfiguration LocalSubstitution',
}
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
