"""Reads setup.cfg and pyproject.toml, which can replace the arguments of setup()."""

from __future__ import annotations

import os
from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any

from edulaunch.ros.sources.static_values import find_packages

if TYPE_CHECKING:
    from configparser import ConfigParser

Warn = Callable[[str, str], None]
"""Called with the file and the message."""

SCRIPTS = {'scripts': 'console_scripts', 'gui-scripts': 'gui_scripts'}


def read_setup_cfg(folder: str, warn: Warn) -> ConfigParser:
    """Return the content of setup.cfg without changing upper-case letters. The result is empty if the file is missing or
    unreadable.
    """
    from configparser import ConfigParser, Error

    file = os.path.join(folder, 'setup.cfg')
    parser = ConfigParser(interpolation=None)
    # names of folders and executables keep their capital letters
    parser.optionxform = str  # type: ignore[assignment, method-assign]
    try:
        parser.read(file, encoding='utf-8-sig')
    except (Error, UnicodeDecodeError) as error:
        warn(file, f'cannot be read: {str(error).splitlines()[0]}')
        parser.clear()
    return parser


def setup_cfg_options(folder: str, parser: ConfigParser) -> dict[str, Any]:
    """Return the sections [options ...] of setup.cfg under the names of the arguments of setup()."""

    def section(name: str) -> dict[str, str]:
        return dict(parser[name]) if parser.has_section(name) else {}

    section_options = section('options')
    options: dict[str, Any] = {
        name: _listed(section_options[name]) for name in ('packages', 'py_modules', 'scripts') if name in section_options
    }
    folders = [line.partition('=') for line in _listed(section_options.get('package_dir', ''))]
    options['package_dir'] = {name.strip(): place.strip() for name, _, place in folders}
    if section_options.get('packages', '').strip() in ('find:', 'find_namespace:'):
        wanted = {name: _listed(text) for name, text in section('options.packages.find').items()}
        options['packages'] = _found(folder, wanted, namespaces='find_namespace' in section_options['packages'])
    options['entry_points'] = {group: _listed(text) for group, text in section('options.entry_points').items()}
    options['data_files'] = _pairs(folder, {name: _listed(text) for name, text in section('options.data_files').items()})
    return {name: value for name, value in options.items() if value}


def pyproject_options(folder: str, warn: Warn) -> dict[str, Any]:
    """Return the tables [project] and [tool.setuptools] of pyproject.toml under the names of the arguments of setup()."""
    file = os.path.join(folder, 'pyproject.toml')
    if not os.path.isfile(file):
        return {}
    try:
        tomllib: Any = import_module('tomllib')
    except ModuleNotFoundError:
        warn(file, 'is not read by Python 3.10; Python 3.11 and later read it')
        return {}
    try:
        with open(file, 'rb') as stream:
            tables = tomllib.load(stream)
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        warn(file, f'cannot be read: {error}')
        return {}
    project, tool = tables.get('project', {}), tables.get('tool', {}).get('setuptools', {})
    options: dict[str, Any] = {'package_dir': tool.get('package-dir'), 'py_modules': tool.get('py-modules')}
    options['packages'] = _toml_packages(folder, tool.get('packages'))
    options['data_files'] = _pairs(folder, tool.get('data-files', {}))
    options['entry_points'] = {
        group: [f'{name} = {place}' for name, place in project.get(table, {}).items()]
        for table, group in SCRIPTS.items()
        if project.get(table)
    }
    for group, announced in project.get('entry-points', {}).items():
        options['entry_points'][group] = [f'{name} = {place}' for name, place in announced.items()]
    return {name: value for name, value in options.items() if value}


def _toml_packages(folder: str, value: Any) -> Any:
    if not isinstance(value, dict):
        return value
    wanted = value.get('find', {})
    return _found(folder, wanted, namespaces=wanted.get('namespaces', True))


def _found(folder: str, wanted: dict[str, Any], namespaces: bool) -> list[str]:
    """Return the packages that setuptools' `find` finds. `where` is a list of folders."""
    where = wanted.get('where') or ['.']
    exclude, include = wanted.get('exclude') or (), wanted.get('include') or ('*',)
    marker = '' if namespaces else '__init__.py'
    return [name for place in where for name in find_packages(os.path.join(folder, place), exclude, include, marker)]


def _pairs(folder: str, sections: dict[str, list[str]]) -> list[tuple[str, list[str]]]:
    """Return the value of data_files= for {folder: patterns}. Unlike in setup(), the patterns are expanded here."""
    return [
        (target, [name for pattern in patterns for name in _expanded(folder, pattern)]) for target, patterns in sections.items()
    ]


def _expanded(folder: str, pattern: str) -> list[str]:
    from glob import glob

    if not any(sign in pattern for sign in '*?['):
        return [pattern]
    return sorted(
        os.path.relpath(path, folder) for path in glob(os.path.join(folder, pattern), recursive=True) if os.path.isfile(path)
    )


def _listed(text: str) -> list[str]:
    """Return the lines of a value. If it has only one line, return its comma-separated words."""
    parts = text.splitlines() if '\n' in text else text.split(',')
    return [part.strip() for part in parts if part.strip() and not part.strip().startswith('#')]
