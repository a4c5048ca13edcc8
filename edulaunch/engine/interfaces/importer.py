"""Makes `import geometry_msgs.msg` work for packages that have interface files. Each class is created on its first use."""

from __future__ import annotations

import sys
from importlib.machinery import ModuleSpec, PathFinder
from types import FrameType, ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.interfaces.registry import KINDS_OF_INTERFACE
from edulaunch.errors import InterfaceError

if TYPE_CHECKING:
    from collections.abc import Sequence
    from importlib.abc import Loader

    from edulaunch.engine.interfaces.registry import Registry
else:
    Loader = object  # importlib.abc costs more to import than this whole module


class InterfaceFinder(Loader):
    """A finder for `sys.meta_path` that provides `<package>.msg`, `<package>.srv` and `<package>.action`.

    It also provides `<package>` itself, unless Python finds a real package with this name. The finder must come before
    Python's path finder, because the folder `my_interfaces/msg` of a workspace looks like a namespace package.
    """

    def __init__(self, registry: Registry) -> None:
        self.registry = registry

    def __repr__(self) -> str:
        return 'edulaunch interfaces'  # shown in the repr of the modules

    def find_spec(self, fullname: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> ModuleSpec | None:
        """Return the spec of a module that this finder provides. Return None for any other module."""
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
        """Return the module for a spec. This method implements the import protocol."""

        depth = spec.name.count('.')
        if depth == 0:
            return None
        if depth == 1:
            return InterfaceModule(spec.name, self.registry)
        interface = self._interface(spec.name)
        return PartModule(spec.name, self.registry, interface) if interface else None

    def exec_module(self, module: ModuleType) -> None:
        """Do nothing, because each class is created on its first use. This method implements the import protocol."""

    def invalidate_caches(self) -> None:
        """Read the folders of the registry again; `importlib.invalidate_caches()` calls this method."""
        self.registry.refresh()

    def _interface(self, fullname: str) -> str | None:
        """Return the type that a module defines: 'turtlesim/srv/TeleportAbsolute' for 'turtlesim.srv._teleport_absolute'."""
        from edulaunch.engine.interfaces.spec import module_name

        package, kind, module = fullname.split('.')
        return next(
            (f'{package}/{kind}/{name}' for name in self.registry.names(package, kind) if f'_{module_name(name)}' == module), None
        )


def install(registry: Registry) -> InterfaceFinder:
    """Make the interfaces of a registry importable, and return the new finder. An earlier finder and its modules are removed."""
    uninstall()
    finder = InterfaceFinder(registry)
    sys.meta_path.insert(0, finder)
    return finder


def installed_registry() -> Registry | None:
    """Return the registry whose interfaces are importable now, or None if there is no such registry."""
    return next((finder.registry for finder in sys.meta_path if isinstance(finder, InterfaceFinder)), None)


def uninstall() -> None:
    """Remove the finder, and the modules that the finder has created."""
    finders = [finder for finder in sys.meta_path if isinstance(finder, InterfaceFinder)]
    for finder in finders:
        sys.meta_path.remove(finder)
    for name, module in list(sys.modules.items()):
        if getattr(getattr(module, '__spec__', None), 'loader', None) in finders:
            del sys.modules[name]


def _is_real_package(name: str) -> bool:
    """Return whether Python itself finds a module with this name. A bare folder (namespace package) is ignored."""
    spec = PathFinder.find_spec(name)
    return spec is not None and spec.loader is not None and spec.origin is not None


class InterfaceModule(ModuleType):
    """The module `<package>.msg`, `.srv` or `.action`, with one class for each interface file.

    A wrong name raises Python's own ImportError or AttributeError. The nearest name, or the module that has the type, is attached
    as a fact.
    """

    def __init__(self, name: str, registry: Registry) -> None:
        package, kind = name.split('.')
        super().__init__(name, f'The {kind} interfaces of {package}.')
        self._registry = registry
        self.__all__ = registry.names(package, kind)

    def __getattr__(self, name: str) -> Any:
        service, _, part = name.rpartition('_')
        is_part = self.__name__.endswith('.srv') and part in ('Request', 'Response', 'Event') and service in self.__all__
        if is_part or name in self.__all__:
            cls = self._registry.get(f'{self.__name__.replace(".", "/")}/{name}')
            setattr(self, name, cls)
            return cls
        if name.startswith('__'):
            raise AttributeError(f'module {self.__name__!r} has no attribute {name!r}')
        raise self._no_name(name, sys._getframe(1))

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.__all__})

    def _no_name(self, name: str, asker: FrameType) -> Exception:
        from edulaunch.engine.facts import with_facts  # imported here, because every start loads this module
        from edulaunch.engine.nearest import nearest

        # `from m import X` replaces any AttributeError by an ImportError, which does not have our facts.
        error: Exception = AttributeError(f'module {self.__name__!r} has no attribute {name!r}', name=name, obj=self)
        if _is_from_import(asker):
            error = ImportError(f'cannot import name {name!r} from {self.__name__!r} (unknown location)', name=self.__name__)
        package, kind = self.__name__.split('.')
        homes = self._registry.homes(name)
        near = nearest(name, self._registry.names(package, kind))
        return with_facts(error, 'messages.no-interface', interface=name, module=self.__name__, homes=homes, near=near)


class PartModule(ModuleType):
    """A module such as `<package>.msg._twist`. The module is the `__module__` of a class, where pickle finds the class."""

    def __init__(self, name: str, registry: Registry, interface: str) -> None:
        super().__init__(name)
        self._registry = registry
        self._interface = interface  # 'turtlesim/srv/Spawn'

    def __getattr__(self, name: str) -> Any:
        own = self._interface.rpartition('/')[2]
        if name.startswith('Metaclass_') and name != 'Metaclass_':
            return type(getattr(self, name.removeprefix('Metaclass_')))
        if name == own or name.startswith(f'{own}_'):
            try:
                cls = self._registry.get(f'{self._interface.rpartition("/")[0]}/{name}')
            except InterfaceError:
                raise AttributeError(f'module {self.__name__!r} has no attribute {name!r}') from None
            setattr(self, name, cls)
            return cls
        raise AttributeError(f'module {self.__name__!r} has no attribute {name!r}')


def _is_from_import(frame: FrameType) -> bool:
    """Return whether the frame is executing `from module import name` at this moment."""
    from opcode import opmap

    return frame.f_code.co_code[frame.f_lasti] == opmap['IMPORT_FROM']
