"""`__builtins__` of a simulated program."""

from __future__ import annotations

import builtins
from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


def make(view: ModuleType, process: Process) -> ModuleType:
    """`builtins`, whose names are those that the program's code uses: what it adds or replaces there is its own."""
    view.__dict__.update(_private_builtins(process, process.loader.import_))
    return view


def _private_builtins(process: Process, import_: Callable[..., Any]) -> dict[str, Any]:
    """Python's builtins with `__import__`, `print`, `input`, `open`, `breakpoint`, `exit` and `quit` of this process."""

    def private_print(
        *values: object, sep: str | None = None, end: str | None = None, file: Any = None, flush: bool = False
    ) -> None:
        if file is None:
            view: Any = process.loader.modules.get('sys')
            file = process.stdout if view is None else view.stdout
        file.write((' ' if sep is None else sep).join(map(str, values)) + ('\n' if end is None else end))
        if flush:
            file.flush()

    def private_input(prompt: object = '') -> str:
        view: Any = process.loader.modules.get('sys') or process
        view.stdout.write(str(prompt))
        line: str = view.stdin.readline()
        if not line:
            raise EOFError('EOF when reading a line')
        return line.rstrip('\n')

    def private_open(file: Any, *arguments: Any, **options: Any) -> Any:
        if process.cwd is not None and not isinstance(file, int):
            import os

            file = os.path.join(os.fsencode(process.cwd) if isinstance(file, bytes) else process.cwd, file)
        return open(file, *arguments, **options)

    def private_exit(code: object = None) -> None:
        raise SystemExit(code)

    def private_breakpoint(*_: Any, **__: Any) -> None:
        process.note('breakpoint', f'{process.name} called breakpoint(): it has no terminal, so it goes on')

    return {
        **builtins.__dict__,
        'breakpoint': private_breakpoint,
        '__import__': import_,
        'print': private_print,
        'input': private_input,
        'open': private_open,
        'exit': private_exit,
        'quit': private_exit,
    }
