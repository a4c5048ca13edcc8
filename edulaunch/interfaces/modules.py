"""The modules `geometry_msgs.msg` and `geometry_msgs.msg._twist`, whose classes are made when first asked
for.
"""

from __future__ import annotations

import sys
from types import FrameType, ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.errors import InterfaceError
from edulaunch.facts import with_facts
from edulaunch.nearest import nearest

if TYPE_CHECKING:
    from edulaunch.interfaces.registry import Registry


class InterfaceModule(ModuleType):
    """`<package>.msg`, `.srv` or `.action`: one class for each interface file.

    A wrong name is Python's own ImportError or AttributeError, which knows the nearest name, or where the
    type is.
    """

    def __init__(self, name: str, registry: Registry) -> None:
        package, kind = name.split('.')
        super().__init__(name, f'The {kind} interfaces of {package}.')
        self._registry = registry
        self.__all__ = registry.names(package, kind)

    def __getattr__(self, name: str) -> Any:
        if name in self.__all__:
            cls = self._registry.get(f'{self.__name__.replace(".", "/")}/{name}')
            setattr(self, name, cls)
            return cls
        if name.startswith('__'):
            raise AttributeError(f'module {self.__name__!r} has no attribute {name!r}')
        raise self._no_name(name, sys._getframe(1))

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.__all__})

    def _no_name(self, name: str, asker: FrameType) -> Exception:
        # `from m import X` turns any AttributeError into an ImportError of its own, without our facts.
        error: Exception = AttributeError(f'module {self.__name__!r} has no attribute {name!r}', name=name, obj=self)
        if _is_from_import(asker):
            error = ImportError(f'cannot import name {name!r} from {self.__name__!r} (unknown location)', name=self.__name__)
        package, kind = self.__name__.split('.')
        homes = homes_of(self._registry, name)
        near = nearest(name, self._registry.names(package, kind))
        return with_facts(error, 'messages.no-interface', interface=name, module=self.__name__, homes=homes, near=near)


class PartModule(ModuleType):
    """`<package>.msg._twist`: where a class says it comes from; pickle finds it here."""

    def __init__(self, name: str, registry: Registry, interface: str) -> None:
        super().__init__(name)
        self._registry = registry
        self._interface = interface  # 'turtlesim/srv/Spawn'

    def __getattr__(self, name: str) -> Any:
        own = self._interface.rpartition('/')[2]
        if name == own or name.startswith(f'{own}_'):
            try:
                cls = self._registry.get(f'{self._interface.rpartition("/")[0]}/{name}')
            except InterfaceError:
                raise AttributeError(f'module {self.__name__!r} has no attribute {name!r}') from None
            setattr(self, name, cls)
            return cls
        raise AttributeError(f'module {self.__name__!r} has no attribute {name!r}')


def _is_from_import(frame: FrameType) -> bool:
    """Whether the frame is executing `from module import name` at this moment."""
    from opcode import opmap

    return frame.f_code.co_code[frame.f_lasti] == opmap['IMPORT_FROM']


def homes_of(registry: Registry, name: str, kind: str | None = None) -> list[str]:
    """The modules that have an interface of this name: homes_of(registry, 'Twist') -> ['geometry_msgs.msg']."""
    return [full.rpartition('/')[0].replace('/', '.') for full in registry.types(kind) if full.endswith(f'/{name}')]
