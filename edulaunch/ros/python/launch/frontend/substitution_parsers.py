"""The built-in `$(name ...)`: the class that each creates, and its number of arguments.

An argument is a list of substitutions. As in upstream, a wrong number of arguments raises one of two error types.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

Parsed = tuple[type, dict[str, Any]]

Argument = list[Any]
Keywords = Callable[[list[Argument]], dict[str, Any]]


class LateSubstitution:
    """Parses `$(name ...)` for a class that is imported on first use.

    :param keywords: a function that converts the arguments of the `$(...)` to the keyword arguments of the class.
    """

    def __init__(self, module: str, class_name: str, keywords: Keywords) -> None:
        self.module = module
        self.class_name = class_name
        self.keywords = keywords
        self._class: Any = None

    def __call__(self, arguments: list[Argument]) -> Parsed:
        kwargs = self.keywords(arguments)
        if self._class is None:
            self._class = getattr(import_module(self.module), self.class_name)
        return self._class, kwargs


def takes(text: str, minimum: int, *names: str, error: type[Exception] = TypeError) -> Keywords:
    """Return keyword arguments by position, from `minimum` up to the length of `names`. Raise `error` with `text` for any other
    number.
    """

    def keywords(arguments: list[Argument]) -> dict[str, Any]:
        if not minimum <= len(arguments) <= len(names):
            raise error(text)
        return dict(zip(names, arguments, strict=False))

    return keywords


def _takes_all(arguments: list[Argument]) -> dict[str, Any]:
    # As in upstream, where this keyword makes $(any ...) and $(all ...) fail.
    return {'args': arguments}


_EXPRESSION = takes('eval substitution expects 1 or 2 arguments', 1, 'expression', 'python_modules')


def _takes_expression(arguments: list[Argument]) -> dict[str, Any]:
    kwargs = _EXPRESSION(arguments)
    if 'python_modules' in kwargs:
        kwargs['python_modules'] = _module_names(kwargs['python_modules'])
    return kwargs


def _module_names(argument: Argument) -> list[str]:
    """Return the modules in a comma-separated literal. Substitutions are not possible in this argument."""
    text = argument[0].perform(None) if argument else ''
    return [name.strip() for name in text.split(',')] if text else []


def _makes(class_name: str, module: str, keywords: Keywords) -> LateSubstitution:
    return LateSubstitution(f'launch.substitutions.{module}', class_name, keywords)


_NOTHING = '{} substitution does not expect any argument'
_LEFT_RIGHT = takes('and substitution expects 2 arguments', 2, 'left', 'right')
_LOG_DIR = _makes('LaunchLogDir', 'launch_log_dir', takes(_NOTHING.format('launch_log_dir'), 0))

BUILT_IN_SUBSTITUTIONS: dict[str, LateSubstitution] = {
    'var': _makes(
        'LaunchConfiguration',
        'launch_configuration',
        takes('var substitution expects 1 or 2 arguments', 1, 'variable_name', 'default'),
    ),
    'env': _makes(
        'EnvironmentVariable',
        'environment_variable',
        takes('env substitution expects 1 or 2 arguments', 1, 'name', 'default_value'),
    ),
    'eval': _makes('PythonExpression', 'python_expression', _takes_expression),
    'command': _makes('Command', 'command', takes('command substitution expects 1 or 2 arguments', 1, 'command', 'on_stderr')),
    'find-exec': _makes(
        'FindExecutable', 'find_executable', takes('find-exec substitution expects 1 argument', 1, 'name', error=AttributeError)
    ),
    'dirname': _makes('ThisLaunchFileDir', 'this_launch_file_dir', takes(_NOTHING.format('dirname'), 0)),
    'filename': _makes('ThisLaunchFile', 'this_launch_file', takes(_NOTHING.format('filename'), 0)),
    'launch_log_dir': _LOG_DIR,
    'log_dir': _LOG_DIR,
    'anon': _makes('AnonName', 'anon_name', takes('anon substitution expects 1 argument', 1, 'name')),
    'not': _makes('NotSubstitution', 'boolean_substitution', takes('not substitution expects 1 argument', 1, 'value')),
    'and': _makes('AndSubstitution', 'boolean_substitution', _LEFT_RIGHT),
    'or': _makes('OrSubstitution', 'boolean_substitution', _LEFT_RIGHT),
    'any': _makes('AnySubstitution', 'boolean_substitution', _takes_all),
    'all': _makes('AllSubstitution', 'boolean_substitution', _takes_all),
    'equals': _makes('EqualsSubstitution', 'equals_substitution', _LEFT_RIGHT),
    'not-equals': _makes('NotEqualsSubstitution', 'not_equals_substitution', _LEFT_RIGHT),
    'if': _makes(
        'IfElseSubstitution',
        'if_else_substitution',
        takes('if substitution expects 2 or 3 arguments', 2, 'condition', 'if_value', 'else_value'),
    ),
    'file-content': _makes(
        'FileContent', 'file_content', takes('file-content substitution expects 1 argument', 1, 'path', error=AttributeError)
    ),
}
