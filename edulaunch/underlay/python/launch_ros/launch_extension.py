"""What launch_ros adds to XML and YAML launch files, told to launch when it reads the first one."""

from __future__ import annotations

from launch.frontend.registry import action_parse_methods, substitution_parse_methods
from launch.frontend.substitution_parsers import Keywords, LateSubstitution, takes

from ._elements import ELEMENTS


def _makes(class_name: str, module: str, keywords: Keywords) -> LateSubstitution:
    return LateSubstitution(f'launch_ros.substitutions.{module}', class_name, keywords)


SUBSTITUTIONS = {
    'find-pkg-share': _makes(
        'FindPackageShare',
        'find_package',
        takes('find-pkg-share substitution expects 1 argument', 1, 'package', error=AttributeError),
    ),
    'find-pkg-prefix': _makes(
        'FindPackagePrefix',
        'find_package',
        takes('find-pkg-prefix substitution expects 1 argument', 1, 'package', error=AttributeError),
    ),
    'exec-in-pkg': _makes(
        'ExecutableInPackage',
        'executable_in_package',
        takes('exec-in-pkg substitution expects 2 arguments', 2, 'executable', 'package', error=AttributeError),
    ),
    'param': _makes('Parameter', 'parameter', takes('param substitution expects 1 or 2 arguments', 1, 'name', 'default')),
}

action_parse_methods.update(ELEMENTS)
substitution_parse_methods.update(SUBSTITUTIONS)
