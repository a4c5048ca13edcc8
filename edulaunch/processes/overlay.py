"""What a student's workspaces add to the underlay: modules and interfaces. Read once per index, when first asked for."""

from __future__ import annotations

import os
from functools import cached_property
from typing import TYPE_CHECKING

from edulaunch.interfaces.running import answer_with
from edulaunch.sim.task import running_task

if TYPE_CHECKING:
    from edulaunch.interfaces.importer import InterfaceFinder
    from edulaunch.interfaces.registry import Registry
    from edulaunch.packages import Index


class Overlay:
    """The importable part of one index.

    Packages that the underlay has too keep the underlay's interfaces, since its programs talk with them; they are taken from
    the workspace only when that has types which the underlay lacks.
    """

    def __init__(self, index: Index) -> None:
        self._index = index

    @cached_property
    def modules(self) -> dict[str, str]:
        """Top-level modules of the workspaces, as their build files install them: name -> folder or .py file."""
        return self._index.python_modules()

    @cached_property
    def interface_packages(self) -> frozenset[str]:
        """Packages whose interfaces come from a workspace."""
        from edulaunch.interfaces.underlay import underlay_registry

        shared, folders = underlay_registry(), self._interface_folders
        return frozenset(name for name in folders if not shared.has(name) or _adds(folders[name], name, shared))

    @cached_property
    def _interface_folders(self) -> dict[str, str]:
        from edulaunch.underlay_place import underlay_prefix

        inside = os.path.join(underlay_prefix(), 'share')
        return {os.path.basename(folder): folder for folder in self._index.interface_roots() if os.path.dirname(folder) != inside}

    @cached_property
    def registry(self) -> Registry:
        """The interfaces that programs over this index see."""
        from edulaunch.interfaces.registry import Registry
        from edulaunch.interfaces.underlay import underlay_registry

        own = self.interface_packages
        if not own:
            return underlay_registry()
        roots = list(dict.fromkeys(os.path.dirname(folder) for folder in self._interface_folders.values()))
        return Registry(roots, underlay_registry(), leave=frozenset(self._interface_folders) - own)

    @cached_property
    def finder(self) -> InterfaceFinder:
        """Makes the modules `my_interfaces.msg` ...; it is not on `sys.meta_path`, so nobody else sees them."""
        from edulaunch.interfaces.importer import InterfaceFinder

        return InterfaceFinder(self.registry)


def _adds(folder: str, package: str, shared: Registry) -> bool:
    """Whether a share folder has an interface that the underlay's package of that name lacks."""
    return any(
        name.removesuffix(f'.{kind}') not in shared.names(package, kind)
        for kind in ('msg', 'srv', 'action')
        if os.path.isdir(os.path.join(folder, kind))
        for name in sorted(os.listdir(os.path.join(folder, kind)))
        if name.endswith(f'.{kind}')
    )


def _registry_of_the_running_program() -> Registry | None:
    task = running_task()
    owner = None if task is None else task.owner
    overlay: Overlay | None = None if owner is None else owner.overlay
    return overlay.registry if overlay is not None and overlay.interface_packages else None


answer_with(_registry_of_the_running_program)
