"""Mistakes that end in "No executable found": entry points that name nothing, and nodes that nothing names."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator

from edulaunch.nearest import nearest
from edulaunch.workspace.finding import Mistake
from edulaunch.workspace.sources import SourcePackage, parsed, read_text


def of_package(package: SourcePackage) -> Iterator[Mistake]:
    """Mistakes of one package; of one that cannot be built nothing else is certain."""
    if package.contents.broken is not None:
        return
    yield from _wrong_entry_points(package)
    if package.is_python:
        yield from _nodes_without_entry_point(package)
    else:
        yield from _scripts(package)


def _wrong_entry_points(package: SourcePackage) -> Iterator[Mistake]:
    for place, (module, function) in package.contents.entry_points.items():
        entry = f'{os.path.basename(place)} = {module}:{function}'
        line = _line_with(package.build_file(), module)
        file = _module_file(package, module)
        if file is None:
            near = nearest(module, _modules(package))
            yield Mistake(
                package.build_file(),
                line,
                f'the entry point {entry!r} names the module {module!r}, which is not there',
                f'did you mean {near!r}?' if near else None,
            )
            continue
        tree = parsed(file)
        names = [] if tree is None else _defined(tree)
        wanted = function.partition('.')[0]
        if tree is not None and wanted not in names:
            near = nearest(wanted, names)
            yield Mistake(
                package.build_file(),
                line,
                f'the entry point {entry!r} names the function {wanted!r}, which {package.relative(file)} does not have',
                f'did you mean {near!r}?' if near else f'define it: def {wanted}(args=None): ...',
            )


def _module_file(package: SourcePackage, module: str) -> str | None:
    top, _, rest = module.partition('.')
    place = package.contents.python_modules.get(top)
    if place is None:
        return None
    base = os.path.join(place, *rest.split('.')) if rest else place
    return next((path for path in (f'{base}.py', os.path.join(base, '__init__.py'), base) if os.path.isfile(path)), None)


def _modules(package: SourcePackage) -> dict[str, str]:
    """Full names of the package's installed modules, with their files."""
    found = {}
    for top, place in package.contents.python_modules.items():
        for path in package.python_files:
            if path.startswith(place + os.sep):
                name = os.path.relpath(path, os.path.dirname(place))[:-3].replace(os.sep, '.')
                found[name.removesuffix('.__init__')] = path
        if os.path.isfile(place):
            found[top] = place
    return found


def _defined(tree: ast.Module) -> list[str]:
    """Names that a module defines or imports at its top level, those under `if` and `try` too."""
    names = []
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            names.append(node.name)
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            names += [alias.asname or alias.name for alias in node.names]
        elif isinstance(node, ast.Assign):
            names += [target.id for target in node.targets if isinstance(target, ast.Name)]
    return names


def _nodes_without_entry_point(package: SourcePackage) -> Iterator[Mistake]:
    named = {module for module, _ in package.contents.entry_points.values()}
    for module, path in _modules(package).items():
        tree = parsed(path)
        if module not in named and tree is not None and 'rclpy' in read_text(path) and _starts_rclpy(tree):
            leaf = module.rpartition('.')[2]
            yield Mistake(
                path,
                0,
                f'this node has no entry point, so `ros2 run {package.name} {leaf}` does not find it',
                f"add '{leaf} = {module}:main' to console_scripts of setup.py",
            )


def _starts_rclpy(tree: ast.Module) -> bool:
    """Whether there is a main() that starts rclpy."""
    return any(
        isinstance(node, ast.FunctionDef) and node.name == 'main' and 'rclpy.init' in ast.unparse(node) for node in tree.body
    )


def _scripts(package: SourcePackage) -> Iterator[Mistake]:
    """Scripts of a CMake package: not installed as programs, or without the line that says that they are Python."""
    contents = package.contents
    programs = {os.path.realpath(contents.files[name]) for name in contents.programs}
    installed = {os.path.realpath(path): name for name, path in contents.files.items()}
    modules = tuple(place + os.sep for place in contents.python_modules.values())
    for path in package.python_files:
        real, text = os.path.realpath(path), read_text(path)
        runs = '\nif __name__' in text or 'rclpy.init' in text
        if real in programs and runs and not text.startswith('#!'):
            yield Mistake(
                path,
                1,
                'this program has no first line that says what runs it, so it fails with "Exec format error"',
                'make the first line: #!/usr/bin/env python3',
            )
        elif real not in programs and runs and 'rclpy.init' in text and not path.startswith(modules):
            if real in installed and installed[real].startswith('lib/'):
                sentence = 'this program is installed as a plain file that may not be executed'
            else:
                command = f'ros2 run {package.name} {os.path.basename(path)}'
                sentence = f'this program is not installed, so `{command}` does not find it'
            yield Mistake(
                path,
                0,
                sentence,
                f'add install(PROGRAMS {package.relative(path)} DESTINATION lib/${{PROJECT_NAME}}) to CMakeLists.txt',
            )


def _line_with(file: str, word: str) -> int:
    return next((number for number, line in enumerate(read_text(file).splitlines(), 1) if word in line), 0)
