"""What a student's workspaces add to the underlay: modules and interfaces. Read once per index, when first asked for."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

from edulaunch.interfaces.registry import answer_with
from edulaunch.packages.index import interfaces_of
from edulaunch.sim.task import running_task

if TYPE_CHECKING:
    from edulaunch.interfaces.importer import InterfaceFinder
    from edulaunch.interfaces.registry import Registry
    from edulaunch.packages import Index


class Overlay:
    """The importable part of one index."""

    def __init__(self, index: Index) -> None:
        self._index = index

    @cached_property
    def modules(self) -> dict[str, str]:
        """Top-level modules of the workspaces, as their build files install them: name -> folder or .py file."""
        return self._index.python_modules()

    @cached_property
    def _interfaces(self) -> tuple[frozenset[str], Registry]:
        return interfaces_of(self._index)

    @property
    def interface_packages(self) -> frozenset[str]:
        """Packages whose interfaces come from a workspace."""
        return self._interfaces[0]

    @property
    def registry(self) -> Registry:
        """The interfaces that programs over this index see."""
        return self._interfaces[1]

    @cached_property
    def finder(self) -> InterfaceFinder:
        """Makes the modules `my_interfaces.msg` ...; it is not on `sys.meta_path`, so nobody else sees them."""
        from edulaunch.interfaces.importer import InterfaceFinder

        return InterfaceFinder(self.registry)


def _registry_of_the_running_program() -> Registry | None:
    task = running_task()
    owner = None if task is None else task.owner
    overlay: Overlay | None = None if owner is None else owner.overlay
    return overlay.registry if overlay is not None and overlay.interface_packages else None


answer_with(_registry_of_the_running_program)
