"""The code that runs inside a simulated process: the function of an entry point, or a script or module as `__main__`.

The module also handles command lines with Python (`python3 script.py`, `python3 -m package.module`, `./script.py`), because
they probably run ROS nodes.
"""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Callable, Sequence
from typing import Any

from edulaunch.engine.facts import facts_of, with_facts
from edulaunch.engine.nearest import nearest
from edulaunch.engine.packages import Program
from edulaunch.engine.processes.process import Process


def run_program(process: Process, program: Program) -> object:
    """Run a program with the process's private modules, and return the result of its main function (None for a script or module).

    :raises OSError: if the program is native or absent.
    """
    loader = process.loader
    if program.kind != 'module':
        loader.finder.last.extend(program.python_roots)
    if program.kind == 'script':
        loader.roots.append(os.path.dirname(program.path))
        loader.run_file(program.file, '__main__', script=True)
        return None
    if program.kind == 'module':
        loader.roots.insert(0, program.python_roots[0])
        loader.run_module(program.module)
        return None
    if program.kind in ('native', 'absent'):
        raise _cannot_run(program)
    return entry_function(process, program)()


def _cannot_run(program: Program) -> OSError:
    """Return the operating system's error for a file that is missing or built for another machine, with the reason as facts."""
    absent = program.kind == 'absent'
    number, name = (errno.ENOENT, program.path) if absent else (errno.ENOEXEC, program.executable)
    error = OSError(number, os.strerror(number), name)
    if absent:
        return with_facts(error, 'packages.absent-package', package=program.package, belongs_to=program.file)
    return with_facts(error, 'programs.native', built_from=program.file)


def entry_function(process: Process, program: Program) -> Callable[[], object]:
    """Return the function that an entry point names.

    :raises ModuleNotFoundError, AttributeError: with Python's message, if the module or function does not exist. The facts
        name the entry point and the nearest name.
    :raises TypeError: if the entry point names no function, because the script of setuptools then calls the module.
    """
    try:
        found: Any = process.loader.load_entry_module(program.module)
    except ModuleNotFoundError as error:
        if type(error) is ModuleNotFoundError and f'{program.module}.'.startswith(f'{error.name}.'):
            above, _, leaf = program.module.rpartition('.')
            if program.function or hasattr(process.loader.modules.get(above, os), '__path__'):
                _add_facts(program, error, 'module', program.module, _modules_beside(process, program))
                with_facts(error, **facts_of(error), source=process.index.source_folder(program.package))
            else:
                _add_facts(program, error, 'no-function', near=f'{above}:{leaf}')
        raise
    if not program.function:
        not_callable = TypeError("'module' object is not callable")
        _add_facts(program, not_callable, 'no-function', near=f'{program.module}:main' if hasattr(found, 'main') else None)
        raise not_callable
    module = found
    for name in program.function.split('.'):
        try:
            found = getattr(found, name)
        except AttributeError as error:
            own = {key: value for key, value in vars(module).items() if getattr(value, '__module__', None) == program.module}
            functions = [key for key, value in own.items() if not isinstance(value, type)]
            _add_facts(program, error, 'function', program.function, functions, near=name if name in own else None)
            raise
    return found  # type: ignore[no-any-return]


def _modules_beside(process: Process, program: Program) -> list[str]:
    """Return the full names of the modules in the Python package that an entry point names.

    If that package does not exist, use the Python package with the name of the ROS package.
    """
    parent = program.module.rpartition('.')[0]
    package = process.loader.modules.get(parent)
    folders = list(getattr(package, '__path__', ()))
    if package is None:
        parent = program.package
        folders = [folder for root in program.python_roots if os.path.isdir(folder := os.path.join(root, parent))]
    return [
        f'{parent}.{entry[:-3]}'
        for folder in folders
        for entry in sorted(os.listdir(folder))
        if entry.endswith('.py') and not entry.startswith('_')
    ]


def _add_facts(
    program: Program, error: BaseException, kind: str, missing: str = '', known: Sequence[str] = (), near: str | None = None
) -> None:
    entry = f'{program.executable} = {program.module}:{program.function}'.removesuffix(':')
    facts = {'entry': entry, 'executable': program.executable, 'package': program.package, 'missing': missing, 'known': known}
    with_facts(error, f'packages.entry-{kind}', **facts, near=near or nearest(missing, known))


_PYTHON = re.compile(r'python[\d.]*(\.exe)?')
_FLAGS = frozenset(('-u', '-B', '-E', '-I', '-O', '-OO', '-s', '-S', '-q', '-v'))
_FLAGS_WITH_VALUE = frozenset(('-W', '-X'))


def python_command(words: list[str], cwd: str | None, modules: frozenset[str]) -> tuple[list[str], Program] | None:
    """Return the command line as the program gets it, and the program. Return None if Python does not run the command here.

    :param words: the words of the command line.
    :param cwd: the folder in which the command is started, or None for the current folder.
    :param modules: the top-level modules of the workspaces. With `-m`, a real Python runs modules that are neither here nor
        in `cwd`.
    """
    if not words:
        return None
    folder = cwd or os.getcwd()
    if not _PYTHON.fullmatch(os.path.basename(words[0])):
        return _script(words, folder, needs_mark=True)
    position = 1
    while position < len(words) and words[position] in _FLAGS | _FLAGS_WITH_VALUE:
        position += 2 if words[position] in _FLAGS_WITH_VALUE else 1
    rest = words[position:]
    if len(rest) > 1 and rest[0] == '-m':
        name = rest[1]
        top = name.partition('.')[0]
        if top not in modules and not any(os.path.exists(os.path.join(folder, path)) for path in (top, f'{top}.py')):
            return None
        return rest[1:], Program('module', '', name, name, name, python_roots=(folder,))
    return _script(rest, folder, needs_mark=False)


def _script(words: list[str], folder: str, needs_mark: bool) -> tuple[list[str], Program] | None:
    """Return the command line and the program of a Python file, or None.

    If the file is started directly, its first line must name Python.
    """
    path = os.path.normpath(os.path.join(folder, os.path.expanduser(words[0]))) if words else ''
    if not path.endswith('.py') or not os.path.isfile(path) or (needs_mark and not _is_marked(path)):
        return None
    return words, Program('script', '', os.path.basename(path), path, file=path)


def _is_marked(path: str) -> bool:
    with open(path, 'rb') as file:
        first = file.readline(200)
    return first.startswith(b'#!') and b'python' in first and os.access(path, os.X_OK)
