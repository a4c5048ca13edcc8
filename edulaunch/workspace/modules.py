"""The modules of a package, and what stands in them; nothing is imported."""

from __future__ import annotations

import ast
import os

from edulaunch.workspace.sources import SourcePackage, read_text


def module_file(package: SourcePackage, module: str) -> str | None:
    """The file of a module that the package installs."""
    top, _, rest = module.partition('.')
    place = package.contents.python_modules.get(top)
    if place is None:
        return None
    base = os.path.join(place, *rest.split('.')) if rest else place
    return next((path for path in (f'{base}.py', os.path.join(base, '__init__.py'), base) if os.path.isfile(path)), None)


def modules_of(package: SourcePackage) -> dict[str, str]:
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


def defined_names(tree: ast.Module) -> list[str]:
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


def main_of(tree: ast.Module, name: str) -> ast.FunctionDef | None:
    """The function of that name at the top level."""
    return next((node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == name), None)


def line_with(file: str, word: str) -> int:
    """The first line of a file that has the word; 0 when there is none."""
    return next((number for number, line in enumerate(read_text(file).splitlines(), 1) if word in line), 0)
