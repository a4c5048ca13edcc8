"""Rules about mistakes that cause "No executable found": invalid entry points, and nodes without an entry point."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.sources.builds import executables_launched
from edulaunch.engine.nearest import nearest, nearest_spelling
from edulaunch.ros.sources.source_package import defined_names, line_with, main_of, module_file, modules_of, parsed, read_text

if TYPE_CHECKING:
    from edulaunch.advice.source_package import PackageInWorkspace
    from edulaunch.ros.sources.source_package import SourcePackage

LESSON = '07_packages'


@rule(
    'packages.entry-point-module',
    what="the entry point '{entry}' names the module {module}, which does not exist",
    why='`ros2 run {package} {executable}` ends with ModuleNotFoundError',
    do=(
        'write {near} instead of {module}',
        'move {lying} to {wanted}, where a build installs it',
        'create the file {wanted}, or name the module that contains the node',
    ),
    lesson=LESSON,
    level='error',
    edits=(('{module}', '{near}', 'near'),),
)
def entry_point_module(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report an entry point in setup.py or setup.cfg whose module is not installed by setup()."""
    package = source.package
    for executable, module, function in _entry_points(source):
        if module_file(package, module) is None and not _is_of_another(source, module):
            leaf = module.rpartition('.')[2]
            near = _meant(package, executable, module)
            near = None if any(near == other for _, other, _ in _entry_points(source)) else near
            lying = [package.relative(path) for path in package.python_files if os.path.basename(path) == f'{leaf}.py']
            facts: dict[str, Any] = {'near': near, 'lying': next(iter(lying), None), 'wanted': module.replace('.', '/') + '.py'}
            yield _of_entry(package, executable, module, function, **facts)


def _meant(package: SourcePackage, executable: str, module: str) -> str | None:
    """Return the module that an entry point with a wrong module probably means, or None."""
    leaf, modules = module.rpartition('.')[2], modules_of(package)
    if leaf == 'py' and module[:-3] in modules:
        return module[:-3]
    near = nearest(module, [one for one in modules if nearest_spelling(leaf, [one.rpartition('.')[2]])])
    same = [
        one for one, path in modules.items() if one.rpartition('.')[2] in (leaf, executable) and not path.endswith('__init__.py')
    ]
    return near or (same[0] if len(same) == 1 else None)


def _is_of_another(source: PackageInWorkspace, module: str) -> bool:
    """Return whether a module belongs to another package of the workspace. A build accepts such an entry point."""
    top, folder = module.partition('.')[0], os.path.dirname(source.package.folder)
    return top != source.package.name and (
        top in source.around.packages() or os.path.isfile(os.path.join(folder, top, 'package.xml'))
    )


@rule(
    'packages.entry-point-function',
    what="the entry point '{entry}' names the function {function}, which {written} does not contain",
    why='`ros2 run {package} {executable}` ends with AttributeError',
    do=('write {near} instead of {function}', 'define `def {function}(args=None): ...` in {written}'),
    lesson=LESSON,
    level='error',
    edits=((':{function}', ':{near}', 'near'),),
)
def entry_point_function(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report an entry point whose function does not exist: the module neither defines nor imports it at its top level."""
    for package, executable, module, function, path, tree in _read_entry_points(source):
        names, wanted = defined_names(tree), function.partition('.')[0]
        if function and wanted not in names:
            written = package.relative(path)
            yield _of_entry(package, executable, module, wanted, written=written, near=nearest(wanted, names))


@rule(
    'packages.entry-point-colon',
    what="the entry point '{entry}' has no function after a colon",
    why='`ros2 run {package} {executable}` ends with {error}',
    do=(
        "write '{executable} = {near}'",
        'remove the entry point, or write a function in {written} and name this function after a colon',
    ),
    lesson=LESSON,
    level='error',
    edits=(('{entry}', '{executable} = {near}', 'word'),),
    hides=('packages.entry-point-module',),
)
def entry_point_colon(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report an entry point without a colon, `package.module` or `package.module.main`.

    A build installs it, but it cannot start.
    """
    package = source.package
    for executable, module, function in _entry_points(source):
        above, _, leaf = module.rpartition('.')
        path = module_file(package, module)
        if not function and path is not None:
            error = "TypeError: 'module' object is not callable"
            tree = parsed(path)
            near = f'{module}:main' if tree and 'main' in defined_names(tree) else None
            yield _of_entry(package, executable, module, function, near=near, written=package.relative(path), error=error)
            continue
        outer = None if function else module_file(package, above)
        tree = parsed(outer) if outer else None
        if tree is not None:
            meant = _meant(package, executable, module)
            near = f'{above}:{leaf}' if leaf in defined_names(tree) else f'{meant}:main' if meant else None
            if near is not None:
                yield _of_entry(package, executable, module, function, near=near, error='ModuleNotFoundError')


@rule(
    'packages.main-wants-arguments',
    what="the entry point '{entry}' calls {function}() without arguments, but the function requires {wanted}",
    why='`ros2 run {package} {executable}` ends with TypeError: {function}() missing required positional arguments',
    do='add a default value, as in `def {function}({first}=None):`',
    lesson=LESSON,
    level='error',
)
def main_wants_arguments(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a main function with required arguments. The script that setuptools generates calls it without arguments."""
    for package, executable, module, function, path, tree in _read_entry_points(source):
        called = main_of(tree, function)
        if called is None:
            continue
        signature = called.args
        wanted = [one.arg for one in (*signature.posonlyargs, *signature.args)][: -len(signature.defaults) or None]
        if wanted:
            facts = {'wanted': wanted, 'first': wanted[0]}
            yield _of_entry(package, executable, module, function, path, called.lineno, **facts)


@rule(
    'packages.node-without-entry-point',
    what='the node {file} has no entry point',
    why='`ros2 run {package} {executable}` does not find it',
    do="add '{executable} = {module}:main' to console_scripts in setup.py",
    lesson=LESSON,
    level='error',
    edits=(('', "'{executable} = {module}:main'", 'console_scripts'),),
)
def node_without_entry_point(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a node without an entry point if a launch file of the package starts it, or if the package has no entry points."""
    launched = executables_launched(source)
    for one in _unnamed(source):
        if one.facts['executable'] in launched or not source.package.contents.entry_points:
            yield one


@rule(
    'packages.node-left-out',
    what='{file} has a main() that starts a node, but no entry point',
    why='`ros2 run {package} {executable}` does not find it',
    do="add '{executable} = {module}:main' to console_scripts in setup.py if you want to start it with `ros2 run`",
    lesson=LESSON,
    level='info',
    edits=(('', "'{executable} = {module}:main'", 'console_scripts'),),
)
def node_left_out(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a node without an entry point in a package with other entry points. Such a node may be left out on purpose."""
    launched = executables_launched(source)
    for one in _unnamed(source):
        if one.facts['executable'] not in launched and source.package.contents.entry_points:
            yield one


def _unnamed(source: PackageInWorkspace) -> Iterator[Finding]:
    """Yield a finding for each module without an entry point whose main() starts rclpy.

    Skip a module if a misspelt entry point may mean it.
    """
    package = source.package
    if not (source.is_readable and package.is_python):
        return
    modules = modules_of(package)
    run = executables_launched(source)
    entries = [(name, module) for name, module, _ in _entry_points(source)]
    named = {
        module if module in modules else _meant(package, name, module) or nearest(module, modules) for name, module in entries
    }
    for module, path in modules.items():
        if module not in named and module not in run and _is_node(path):
            name, leaf = os.path.basename(path), module.rpartition('.')[2]
            yield found('file', name, file=path, package=package.name, module=module, executable=leaf)


@rule(
    'packages.node-in-wrong-folder',
    what='the node {file} is in {folder}/, which setup.py does not install',
    why='the build installs only the modules in {package}/, the folder with __init__.py',
    do="move it to {package}/{file}, and add '{executable} = {package}.{executable}:main' to console_scripts in setup.py",
    lesson=LESSON,
    level='error',
)
def node_in_wrong_folder(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report a node in a package with setup.py whose file is neither an installed module nor an installed script."""
    package = source.package
    if not (source.is_readable and package.is_python):
        return
    known, installed = {*modules_of(package).values()}, source.installed
    named = {f'{module.rpartition(".")[2]}.py' for _, module, _ in _entry_points(source)}
    for path in package.python_files:
        if (
            os.path.basename(path) not in named
            and path not in known
            and os.path.realpath(path) not in installed
            and _is_node(path)
        ):
            folder = os.path.basename(os.path.dirname(path))
            name = os.path.basename(path)
            if not os.path.exists(os.path.join(package.folder, package.name, name)):
                yield found('file', name, file=path, folder=folder, package=package.name, executable=name[:-3])


@rule(
    'packages.no-init',
    what='the folder {folder}/ has no __init__.py',
    why='find_packages() finds only folders with an __init__.py, so the build installs nothing from this folder',
    do='create an empty file {folder}/__init__.py',
    lesson=LESSON,
    level='error',
    hides=('packages.entry-point-module', 'packages.node-in-wrong-folder'),
)
def no_init(source: PackageInWorkspace) -> Iterator[Finding]:
    """Report the folder with the package's modules if it has no __init__.py. In that case, setup() does not install it."""
    package = source.package
    folder = os.path.join(package.folder, package.name)
    has_modules = os.path.isdir(folder) and any(name.endswith('.py') for name in os.listdir(folder))
    is_bare = has_modules and not os.path.isfile(os.path.join(folder, '__init__.py'))
    if package.is_python and source.is_readable and is_bare and package.name not in package.contents.python_modules:
        yield found('folder', package.name, file=folder)


def _entry_points(source: PackageInWorkspace) -> Iterator[tuple[str, str, str]]:
    """Yield (executable, module, function) for each entry point, if the build file of the package can be read."""
    if source.is_readable:
        for place, (module, function) in source.package.contents.entry_points.items():
            yield os.path.basename(place), module, function


def _read_entry_points(source: PackageInWorkspace) -> Iterator[tuple[SourcePackage, str, str, str, str, ast.Module]]:
    """Yield (package, executable, module, function, file, syntax tree) for each entry point whose module is valid Python."""
    for executable, module, function in _entry_points(source):
        path = module_file(source.package, module)
        tree = None if path is None else parsed(path)
        if path is not None and tree is not None:
            yield source.package, executable, module, function, path, tree


def _of_entry(
    package: SourcePackage,
    executable: str,
    module: str,
    function: str,
    file: str | None = None,
    line: int | None = None,
    **facts: Any,
) -> Finding:
    build = package.build_file()
    entry = f'{executable} = {module}:{function}'.removesuffix(':')
    facts = {**facts, 'entry': entry, 'module': module, 'function': function, 'package': package.name}
    return found('executable', executable, file=file or build, line=line or line_with(build, module) or None, **facts)


def _is_node(path: str) -> bool:
    """Return whether a module has a main() that starts rclpy."""
    text = read_text(path)
    tree = parsed(path) if 'rclpy' in text else None
    called = None if tree is None else main_of(tree, 'main')
    return called is not None and 'rclpy.init' in ast.unparse(called)
