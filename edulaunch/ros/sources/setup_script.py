"""Determines what a setup.py installs without running it. It also finds undefined names, which always end the script with a
NameError.
"""

from __future__ import annotations

import ast
import builtins
import os
import re
import sys
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from edulaunch.engine.packages.reading import Contents, Manifest, PackageWarning
from edulaunch.ros.sources.setup_tables import pyproject_options, read_setup_cfg, setup_cfg_options
from edulaunch.ros.sources.source_package import line_with, read_text
from edulaunch.ros.sources.static_values import Unknown, first_unknown

_UNCERTAIN = frozenset(('exec', 'eval', 'globals', 'locals', 'vars', '__import__'))
"""Names with which a script may define further names that do not occur in it."""
_GIVEN = frozenset((*dir(builtins), '__file__', '__name__', '__doc__', '__builtins__', '__spec__', '__loader__', '__package__'))


def first_undefined_name(tree: ast.Module) -> tuple[str, int] | None:
    """Return the first undefined name and its line. Return None if there is no such name, or if that cannot be determined.

    The function checks only code that always runs, and not the bodies of functions, conditions, loops and `try`.
    """
    bound = set(_bound(tree))
    used = [node for statement in tree.body for node in _evaluated(statement)]
    if '*' in bound or any(node.id in _UNCERTAIN for node in used):
        return None
    return next(((node.id, node.lineno) for node in used if node.id not in bound and node.id not in _GIVEN), None)


def _bound(tree: ast.Module) -> Iterator[str]:
    """Yield every name that is bound anywhere in the file, at any depth."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id
        elif isinstance(node, ast.alias):
            yield node.asname or node.name.partition('.')[0]
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            yield node.name
        elif isinstance(node, ast.arg):
            yield node.arg
        elif isinstance(node, (ast.Global, ast.Nonlocal)):
            yield from node.names
        elif isinstance(node, ast.ExceptHandler) and node.name or isinstance(node, (ast.MatchAs, ast.MatchStar)) and node.name:
            yield node.name


def _evaluated(node: ast.AST) -> Iterator[ast.Name]:
    """Yield the names that are read when a statement or an expression is evaluated, in order."""
    if isinstance(node, ast.Name):
        yield from [node] if isinstance(node.ctx, ast.Load) else ()
    for child in _surely(node):
        yield from _evaluated(child)


def _surely(node: ast.AST) -> Sequence[ast.AST]:
    """Return the parts of a node that are always evaluated."""
    if isinstance(node, (ast.If, ast.While, ast.IfExp)):
        return [node.test]
    if isinstance(node, (ast.For, ast.comprehension)):
        return [node.iter]
    if isinstance(node, ast.BoolOp):
        return node.values[:1]
    if isinstance(node, (ast.ListComp, ast.SetComp, ast.GeneratorExp, ast.DictComp)):
        return [node.generators[0]]
    if isinstance(node, (ast.Assign, ast.AugAssign, ast.AnnAssign, ast.NamedExpr)):
        return [] if node.value is None else [node.value]
    plain = (ast.Expr, ast.expr, ast.keyword)
    return list(ast.iter_child_nodes(node)) if isinstance(node, plain) and not isinstance(node, ast.Lambda) else []


_SETUP = frozenset(('setuptools.setup', 'distutils.core.setup', 'setup'))
_ENTRY = re.compile(r'\s*([^=]+?)\s*=\s*([\w.]+)\s*(?::\s*([\w.]+)\s*)?(?:\[.*\]\s*)?')
"""The form of an entry that setuptools accepts. It stops at any other entry."""
_JOINED = re.compile(r'(?<=:main)[\w.-]+(?=\s*=)')
"""Two entries of a list without a comma between them."""
_MARKERS = 'share/ament_index/resource_index/packages'


def read_setup_script(manifest: Manifest) -> Contents:
    """Return what an ament_python package installs. A warning reports what a build would reject, or what only a run can
    determine.
    """
    return _SetupScript(manifest).read()


class _SetupScript:
    """One setup.py that is being read."""

    def __init__(self, manifest: Manifest) -> None:
        self.package = manifest.name
        self.folder = manifest.folder
        self.file = self.script = os.path.join(manifest.folder, 'setup.py')
        self.line = self.call = 0
        self.places: dict[str, tuple[str, int]] = {}  # for options that other files define
        self.contents = Contents()

    def read(self) -> Contents:
        options = self._options()
        if options is not None:
            options = self._with_tables(options)
            self._data_files(options)
            self._modules(options)
            self._executables(options)
        for needed, source in (
            (f'share/{self.package}/package.xml', 'package.xml'),
            (f'{_MARKERS}/{self.package}', 'package.xml'),
        ):
            self.contents.files.setdefault(needed, os.path.join(self.folder, source))  # colcon adds both if setup.py lacks them
        return self.contents

    def warn(self, sentence: str, line: int | None = None, file: str | None = None) -> None:
        self.contents.warnings.append(PackageWarning(file or self.file, self.line if line is None else line, sentence))

    def _stop(self, sentence: str, line: int | None = None) -> None:
        self.warn(sentence, line)
        self.contents.broken = self.contents.warnings[-1]

    def _options(self) -> dict[str, Any] | None:
        """Return the keywords of the setup() call."""
        from edulaunch.ros.sources.static_python import StaticPython

        try:
            with open(self.file, 'rb') as stream:
                tree = ast.parse(stream.read(), self.file)
        except FileNotFoundError:
            self.warn('is missing, so this ament_python package cannot be built', 0)
            return None
        except (SyntaxError, ValueError) as error:
            self._stop(f'cannot be read: {getattr(error, "msg", error)}', getattr(error, 'lineno', 0) or 0)
            return None
        undefined = first_undefined_name(tree)
        if undefined is not None:
            name, line = undefined
            forgotten = f'; write import {name} at the top' if name in sys.stdlib_module_names else ''
            self._stop(f"a build stops with NameError: name '{name}' is not defined{forgotten}", line)
            return None
        module = StaticPython(self.file, self.folder, _SETUP)
        module.run(tree.body)
        if not module.calls:
            self.warn('does not call setup(), so a build stops', 0)
            return None
        self.call, options = module.calls[0]
        return options

    def _with_tables(self, options: dict[str, Any]) -> dict[str, Any]:
        """Return all options. setup() overrides setup.cfg, and pyproject.toml overrides both."""

        def warn(file: str, sentence: str) -> None:
            self.warn(sentence, 0, file)

        self.configuration = read_setup_cfg(self.folder, warn)
        configured = setup_cfg_options(self.folder, self.configuration)
        project = pyproject_options(self.folder, warn)
        for file, more in (('setup.cfg', configured.keys() - options.keys()), ('pyproject.toml', project)):
            self.places.update({name: (os.path.join(self.folder, file), 0) for name in more})
        return {**configured, **options, **project}

    def _known(self, options: dict[str, Any], name: str) -> Any:
        """Return an option, with a warning for each part of it that only running the file could determine."""
        self.file, self.line = self.places.get(name, (self.script, self.call))
        value = options.get(name)
        for unknown in _unknowns(value):
            self.warn(
                f'{name}= contains {unknown.why}, which edulaunch cannot compute without running the file; '
                'write the value itself',
                unknown.line,
            )
        return None if isinstance(value, Unknown) else value

    def _data_files(self, options: dict[str, Any]) -> None:
        for entry in self._known(options, 'data_files') or ():
            if first_unknown(entry) is not None and not (isinstance(entry, tuple | list) and isinstance(entry[0], str)):
                continue
            try:
                target, sources = entry
            except (TypeError, ValueError):
                self.warn(f'data_files contains {entry!r}; a pair (folder, [files]) was expected')
                continue
            if str(target).startswith('/'):
                self.warn(f'data_files names the absolute folder {target!r}, outside the workspace; remove the first /')
            if isinstance(sources, str):
                self.warn(f'data_files: the files of {target!r} are one string; a list was expected, [{sources!r}]')
                sources = [sources]
            for source in sources if isinstance(sources, list | tuple) else ():
                if isinstance(source, str):
                    self._data_file(str(target), source)

    def _data_file(self, target: str, source: str) -> None:
        path = os.path.normpath(os.path.join(self.folder, source))
        if os.path.isfile(path):
            name = os.path.normpath(os.path.join(target, os.path.basename(path))).lstrip('/')
            self.contents.files[name] = path
            if name.startswith('lib/') and os.access(path, os.X_OK):
                self.contents.programs.add(name)
            self.contents.interfaces |= path.endswith(('.msg', '.srv', '.action'))
        else:
            kind = 'a folder; only files can be listed, so use glob()' if os.path.isdir(path) else 'not there'
            self.warn(f'data_files lists {source!r}, which is {kind} (a build stops with "can\'t copy {source!r}")')

    def _modules(self, options: dict[str, Any]) -> None:
        """Record the folders and files of the top-level import names in packages= and py_modules=."""
        folders = self._known(options, 'package_dir') or {}
        for name in self._known(options, 'packages') or ():
            if not isinstance(name, str) or '.' in name:
                continue
            path = os.path.normpath(os.path.join(self.folder, folders.get(name) or os.path.join(folders.get('') or '', name)))
            if os.path.isdir(path):
                self.contents.python_modules[name] = path
            else:
                self.warn(
                    f'packages= names {name!r}, but there is no folder {os.path.relpath(path, self.folder)}/ '
                    f'(a build stops with "package directory \'{name}\' does not exist")'
                )
        for name in self._known(options, 'py_modules') or ():
            if isinstance(name, str):
                top, _, inner = name.partition('.')
                path = os.path.normpath(os.path.join(self.folder, folders.get('') or '', top)) + ('' if inner else '.py')
                self.contents.python_modules.setdefault(top, path)

    def _executables(self, options: dict[str, Any]) -> None:
        groups = self._groups(options)
        entries = list(self._console_scripts(groups))
        scripts = [script for script in self._known(options, 'scripts') or () if isinstance(script, str)]
        if not entries and not scripts:
            return
        place = self._script_folder(module for _, module, _ in entries)
        packages = self._known(options, 'packages') or ()
        for name, module, function in entries:
            above = module.rpartition('.')[0]
            if '.' in above and packages and above not in packages and first_unknown(packages) is None:
                self._left_out(name, module, above)
            self.contents.entry_points[f'{place}/{name}'] = (module, function)
        for script in scripts:
            path = os.path.normpath(os.path.join(self.folder, script))
            if os.path.isfile(path):
                self.contents.files[f'{place}/{os.path.basename(path)}'] = path
                self.contents.programs.add(f'{place}/{os.path.basename(path)}')
            else:
                self.warn(f'scripts= lists {script!r}, which is not there')

    def _left_out(self, name: str, module: str, above: str) -> None:
        """Warn about an entry point in an existing folder that no build installs."""
        place = module.replace('.', '/')
        if os.path.isfile(os.path.join(self.folder, f'{place}.py')):
            self.warn(
                f'installs {name!r} of the console_scripts, but not {os.path.dirname(place)}/ with its module (except with '
                f'--symlink-install); add {above!r} to packages=, or create an __init__.py there for find_packages()'
            )

    def _groups(self, options: dict[str, Any]) -> dict[Any, Any]:
        """Return the lines of entry_points= by group. The argument may be a string in ini format."""
        value = self._known(options, 'entry_points')
        if isinstance(value, str):
            return dict(_ini_sections(value))
        return value if isinstance(value, dict) else {}

    def _console_scripts(self, groups: dict[Any, Any]) -> Iterator[tuple[str, str, str]]:
        """Yield (executable, module, function) of each console script. As in setuptools, the function may be missing."""
        for line in (line for kind in ('console_scripts', 'gui_scripts') for line in _lines(groups.get(kind))):
            if not isinstance(line, str) or not line.strip():
                continue
            match = _ENTRY.fullmatch(line)
            if joined := _JOINED.findall(line):
                names = ', '.join([line.partition('=')[0].strip(), *joined])
                place = line_with(self.file, f'{line.partition("=")[0].strip()} =') or None
                self._stop(
                    f'lists the console_scripts {names} without a comma between them, so Python joins them into one', place
                )
            elif match is None:
                self._stop(f"console_scripts has {line.strip()!r}; 'executable = package.module:function' was expected")
            else:
                yield match[1], match[2], match[3] or ''

    def _have_nodes(self, modules: Iterable[str]) -> bool:
        """Return whether any of the modules uses rclpy. A package without nodes intentionally installs its commands into
        `bin`.
        """
        files = [os.path.join(self.folder, *module.split('.')) + '.py' for module in modules]
        return not all(map(os.path.isfile, files)) or any('rclpy' in read_text(path) for path in files)

    def _script_folder(self, modules: Iterable[str]) -> str:
        """Return the folder of executables: the folder in section [install] of setup.cfg, or `bin`."""
        section = self.configuration['install'] if self.configuration.has_section('install') else {}
        value = section.get('install_scripts') or section.get('install-scripts') or ''
        if not value:
            if not self._have_nodes(modules):
                return 'bin'
            self.warn(
                f'has no install_scripts=$base/lib/{self.package} in its section [install], '
                f'so `ros2 run {self.package} ...` and Node() '
                'find no executable of this package',
                0,
                os.path.join(self.folder, 'setup.cfg'),
            )
            return 'bin'
        return os.path.normpath(value.replace('$base', '').lstrip('/'))


def _unknowns(value: Any) -> Iterator[Unknown]:
    """Yield every Unknown inside a value, at most one for each list item."""
    if isinstance(value, Unknown):
        yield value
    elif isinstance(value, dict):
        for item in value.values():
            yield from _unknowns(item)
    elif isinstance(value, list | tuple | set):
        for item in value:
            found = first_unknown(item)
            if found is not None:
                yield found


def _lines(scripts: Any) -> Iterable[Any]:
    return scripts.splitlines() if isinstance(scripts, str) else () if isinstance(scripts, Unknown) else scripts or ()


def _ini_sections(text: str) -> dict[str, list[str]]:
    sections: dict[str, list[str]] = {}
    name = ''
    for line in text.splitlines():
        if line.strip().startswith('['):
            name = line.strip().strip('[]').strip()
        elif line.strip():
            sections.setdefault(name, []).append(line)
    return sections
