"""`sys` of a simulated program: its own arguments, streams, path and modules."""

from __future__ import annotations

import sys as real
from collections import ChainMap
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


class SysView(ModuleType):
    """Everything that is not the program's own comes from the real `sys`, at the moment it is asked for."""

    def __new__(cls, process: Process | str, *arguments: Any) -> ModuleType:  # type: ignore[misc]
        """A program that makes a module of its own by `type(sys)('name')` gets an ordinary one."""
        return ModuleType(process, *arguments) if isinstance(process, str) else super().__new__(cls)

    def __init__(self, process: Process) -> None:
        super().__init__('sys')
        self.__edulaunch_view__ = True
        self.argv = process.argv
        self.stdin = self.__stdin__ = process.stdin
        self.stdout = self.__stdout__ = process.stdout
        self.stderr = self.__stderr__ = process.stderr
        self._shared_path = list(real.path)
        self.path = [*process.loader.roots, *self._shared_path]
        self.modules = ChainMap(process.loader.modules, real.modules)

    def __getattr__(self, name: str) -> Any:
        return getattr(real, name)

    def private_path(self) -> tuple[list[str], list[str]]:
        """The folders that this program put on its path: before the shared ones, and after the first of them."""
        first = next((place for place, folder in enumerate(self.path) if folder in self._shared_path), len(self.path))
        return self.path[:first], [folder for folder in self.path[first:] if folder not in self._shared_path]

    @staticmethod
    def exit(status: object = None) -> None:
        """End this program only."""
        raise SystemExit(status)


def make(view: ModuleType, process: Process) -> ModuleType:
    """See `SysView`."""
    return SysView(process)
