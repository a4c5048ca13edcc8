"""`atexit` of a simulated program: what it registers runs when that program ends, in its own time."""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

Function = TypeVar('Function', bound=Callable[..., object])


def make(view: ModuleType, process: Process) -> ModuleType:
    """`register` and `unregister` for this process."""
    calls = process.exit_calls

    def register(function: Function, /, *arguments: Any, **options: Any) -> Function:
        calls.append((function, arguments, options))
        return function

    def unregister(function: Callable[..., object], /) -> None:
        calls[:] = [call for call in calls if call[0] != function]

    view.__dict__.update(
        register=register,
        unregister=unregister,
        _clear=calls.clear,
        _ncallbacks=lambda: len(calls),
        _run_exitfuncs=process.run_exit_calls,
    )
    return view
