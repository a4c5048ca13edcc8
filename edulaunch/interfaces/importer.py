"""Makes `import geometry_msgs.msg` work for packages that have interface files."""

from __future__ import annotations

import sys
from importlib.machinery import ModuleSpec, PathFinder
from types import ModuleType
from typing import TYPE_CHECKING

from edulaunch.interfaces.registry import KINDS_OF_INTERFACE

if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.abc import Loader

    from edulaunch.interfaces.registry import Registry
else:
    Loader = object  # importlib.abc costs more to import than this whole module


class InterfaceFinder(Loader):
    """A finder for `sys.meta_path`: provides `<package>.msg|srv|action` and, unless Python finds a real one,
    `<package>` itself.

    It must stand before Python's path finder: in a workspace the folder `my_interfaces/msg` looks like a
    namespace package.
    """

    def __init__(self, registry: Registry) -> None:
        self.registry = registry

    def __repr__(self) -> str:
        return 'edulaunch interfaces'  # shown in the repr of the modules

    def find_spec(self, fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> ModuleSpec | None:
        """The spec of a module that this finder provides, else None."""
        package, *rest = fullname.split('.')
        if len(rest) > 2 or not self.registry.has(package):
            return None
        if not rest:
            return None if _is_real_package(package) else ModuleSpec(fullname, self, is_package=True)
        if rest[0] not in KINDS_OF_INTERFACE or not self.registry.has(package, rest[0]):
            return None
        if len(rest) == 1:
            return ModuleSpec(fullname, self, is_package=True)
        return ModuleSpec(fullname, self) if self._interface(fullname) else None

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        """Part of the import protocol."""
        from edulaunch.interfaces.modules import InterfaceModule, PartModule

        depth = spec.name.count('.')
        if depth == 0:
            return None
        if depth == 1:
            return InterfaceModule(spec.name, self.registry)
        interface = self._interface(spec.name)
        return PartModule(spec.name, self.registry, interface) if interface else None

    def exec_module(self, module: ModuleType) -> None:
        """Part of the import protocol: nothing runs, classes are made when first asked for."""

    def invalidate_caches(self) -> None:
        """Called by importlib.invalidate_caches(): look at the folders again."""
        self.registry.refresh()

    def _interface(self, fullname: str) -> str | None:
        """'turtlesim.srv._teleport_absolute' -> 'turtlesim/srv/TeleportAbsolute'."""
        from edulaunch.interfaces.naming import module_name

        package, kind, module = fullname.split('.')
        return next(
            (f'{package}/{kind}/{name}' for name in self.registry.names(package, kind) if f'_{module_name(name)}' == module), None
        )


def install(registry: Registry) -> InterfaceFinder:
    """Make the interfaces of a registry importable, in place of those of an earlier one."""
    uninstall()
    finder = InterfaceFinder(registry)
    sys.meta_path.insert(0, finder)
    return finder


def installed_registry() -> Registry | None:
    """The registry whose interfaces are importable now, if any."""
    return next((finder.registry for finder in sys.meta_path if isinstance(finder, InterfaceFinder)), None)


def uninstall() -> None:
    """Take the finder away, with the modules that it made."""
    finders = [finder for finder in sys.meta_path if isinstance(finder, InterfaceFinder)]
    for finder in finders:
        sys.meta_path.remove(finder)
    for name, module in list(sys.modules.items()):
        if getattr(getattr(module, '__spec__', None), 'loader', None) in finders:
            del sys.modules[name]


def _is_real_package(name: str) -> bool:
    """Whether Python itself finds a module of this name; a bare folder (namespace package) does not count."""
    spec = PathFinder.find_spec(name)
    return spec is not None and spec.loader is not None and spec.origin is not None
