"""Find interface files in share folders, and create each class once. The interfaces of the running program's workspace count, if
there is one. This layer knows no programs, so the code that runs programs sets a function that returns the registry of the
running one.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING, Any

from edulaunch.engine.underlay_place import help_text, underlay_prefix
from edulaunch.errors import InterfaceError

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from edulaunch.engine.interfaces.message import Message
    from edulaunch.engine.interfaces.spec import InterfaceSpec, MessageSpec

KINDS_OF_INTERFACE = ('msg', 'srv', 'action')


class Registry:
    """The interfaces under some share folders, over those of another registry.

    :param roots: folders laid out as `<package>/{msg,srv,action}/<Name>.{msg,srv,action}`; the first one with a package counts.
    :param base: the registry for packages that no root has (that of the underlay for a workspace), whose classes are shared.
    :param leave: packages that come from the base although a root has them, too.
    """

    def __init__(self, roots: Sequence[str | os.PathLike[str]], base: Registry | None = None, leave: Iterable[str] = ()) -> None:
        self.roots = tuple(os.fspath(root) for root in roots)
        self.base = base
        self.leave = frozenset(leave)
        self._packages: dict[str, dict[str, dict[str, str]]] = {}  # package -> kind -> name -> path
        self._folders: dict[str, str] | None = None
        self._specs: dict[str, InterfaceSpec] = {}
        self._classes: dict[str, type[Any]] = {}
        self._one_thread = threading.RLock()  # real threads of a plain script import messages too
        self._making: list[str] = []

    # Existing types

    def packages(self) -> list[str]:
        """Return the names of all packages that have interfaces, sorted."""
        own = [name for name in self._package_folders() if self._files(name)]
        return sorted({*own, *(self.base.packages() if self.base else ())})

    def has(self, package: str, kind: str | None = None) -> bool:
        """Return whether a package has interfaces (of a kind)."""
        files = self._files(package)
        if not files and self.base is not None:
            return self.base.has(package, kind)
        return bool(files) if kind is None else kind in files

    def owns(self, package: str) -> bool:
        """Return whether the interfaces of a package belong to this registry, not to its base."""
        return bool(self._files(package))

    def names(self, package: str, kind: str) -> list[str]:
        """Return the interface names of one kind in a package, sorted: names('turtlesim', 'srv') -> ['Kill',
        'SetPen', ...].
        """
        files = self._files(package)
        if not files and self.base is not None:
            return self.base.names(package, kind)
        return sorted(files.get(kind, ()))

    def types(self, kind: str | None = None) -> list[str]:
        """Return all full type names (of one kind), sorted."""
        return sorted(
            f'{package}/{each}/{name}'
            for package in self.packages()
            for each in KINDS_OF_INTERFACE
            if kind in (None, each)
            for name in self.names(package, each)
        )

    def homes(self, name: str, kind: str | None = None) -> list[str]:
        """Return the modules that have an interface of this name: homes('Twist') -> ['geometry_msgs.msg']."""
        return [full.rpartition('/')[0].replace('/', '.') for full in self.types(kind) if full.endswith(f'/{name}')]

    def path(self, type_name: str) -> str:
        """Return the file that defines 'pkg/kind/Name'.

        :raises InterfaceError: with the nearest type name when there is no such file.
        """
        package, kind, name = self._split(type_name)
        files = self._files(package)
        if not files and self.base is not None and self.base.has(package):
            return self.base.path(type_name)
        try:
            return files[kind][name]
        except KeyError:
            raise self._unknown(type_name) from None

    def text(self, type_name: str) -> str:
        """Return the text of the file that defines a type, from which `ros2 interface show` starts.

        :raises InterfaceError: when there is no such type or its file cannot be read as UTF-8.
        """
        path = self.path(type_name)
        with open(path, encoding='utf-8-sig', errors='replace', newline=None) as file:
            return file.read()

    # Specs and classes

    def spec(self, type_name: str) -> InterfaceSpec:
        """Return the spec of a type, or of a part such as 'turtlesim/srv/Spawn_Request'.

        :raises InterfaceError: when there is no such type or its file is invalid.
        """
        if type_name not in self._specs:
            owner = self._owner(type_name)
            if owner is not self:
                return owner.spec(type_name)
            self._load(type_name)
        return self._specs[type_name]

    def get(self, type_name: str) -> type[Any]:
        """Return the class of 'pkg/kind/Name' (message, service, action, or a part of one), which is created by the first call.
        :raises InterfaceError: when there is no such type, its file is invalid, or it contains itself.
        """
        cls = self._classes.get(type_name)
        if cls is not None:
            return cls
        owner = self._owner(type_name)
        if owner is not self:
            return owner.get(type_name)
        with self._one_thread:
            return self._classes.get(type_name) or self._made(type_name)

    def _made(self, type_name: str) -> type[Any]:
        if type_name in self._making:
            ring = ' -> '.join([*self._making[self._making.index(type_name) :], type_name])
            raise InterfaceError(f'{type_name} contains itself: {ring}', help=help_text('endless'))
        self._making.append(type_name)
        try:
            cls = self._classes[type_name] = self._make(self.spec(type_name))
        finally:
            self._making.pop()
        return cls

    def classes(self) -> list[type[Any]]:
        """Return all classes that exist so far in the order of their creation, those of the base first."""
        return [*(self.base.classes() if self.base else ()), *self._classes.values()]

    def refresh(self) -> None:
        """Read the folders again, because files may have been added; existing classes stay."""
        self._folders = None
        self._packages.clear()

    # Internal

    def _package_folders(self) -> dict[str, str]:
        """Return the folder of each package. They are read only once, because every import needs them."""
        if self._folders is None:
            folders: dict[str, str] = {}
            for root in reversed(self.roots):
                if os.path.isdir(root):
                    folders.update((name, os.path.join(root, name)) for name in os.listdir(root) if name not in self.leave)
            self._folders = folders  # only now, so that a call that fails for a moment is repeated
        return self._folders

    def _files(self, package: str) -> dict[str, dict[str, str]]:
        folder = self._package_folders().get(package)
        if folder is None:
            return {}
        if package not in self._packages:
            self._packages[package] = {kind: files for kind in KINDS_OF_INTERFACE if (files := _interface_files(folder, kind))}
        return self._packages[package]

    def _split(self, type_name: str) -> tuple[str, str, str]:
        parts = type_name.split('/')
        if len(parts) != 3 or parts[1] not in KINDS_OF_INTERFACE:
            raise self._unknown(type_name)
        return parts[0], parts[1], parts[2]

    def _owner(self, type_name: str) -> Registry:
        package = type_name.partition('/')[0]
        if self.base is not None and not self._files(package) and self.base.has(package):
            return self.base
        return self

    def _load(self, type_name: str) -> None:
        """Read a file and keep the specs of everything it defines. The name of a part is the name of its interface, an
        underscore and a word.
        """
        from edulaunch.engine.interfaces.parser import parse
        from edulaunch.engine.interfaces.services import parts_of

        place, slash, last = type_name.rpartition('/')
        whole = place + slash + last.partition('_')[0] if slash else type_name
        parts = parts_of(parse(self.text(whole), whole, self.path(whole)))
        if type_name not in parts:
            raise self._unknown(type_name)
        self._specs.update(parts)

    def _make(self, spec: InterfaceSpec) -> type[Any]:
        from edulaunch.engine.interfaces.generator import make_message
        from edulaunch.engine.interfaces.services import make_action, make_service
        from edulaunch.engine.interfaces.spec import MessageSpec, ServiceSpec

        if isinstance(spec, MessageSpec):
            return make_message(spec, lambda nested: self._nested(spec, nested))
        return make_service(spec, self.get) if isinstance(spec, ServiceSpec) else make_action(spec, self.get)

    def _nested(self, spec: MessageSpec, type_name: str) -> type[Message]:
        """Return the class of a field's type. The error for an unknown type names the line of the field."""
        try:
            return self.get(type_name)
        except InterfaceError as error:
            field = next((each for each in spec.fields if each.type.base == type_name), None)
            if field is None or not str(error.message).startswith('unknown'):
                raise
            raise InterfaceError(
                f"{spec.file}:{field.line}: {error.message}, the type of field '{field.name}'", help=error.help
            ) from None

    def _unknown(self, type_name: str) -> InterfaceError:
        from edulaunch.engine.interfaces.mistakes import unknown_type

        return unknown_type(self, type_name)


def _interface_files(folder: str, kind: str) -> dict[str, str]:
    inside = os.path.join(folder, kind)
    try:
        names = os.listdir(inside)
    except (FileNotFoundError, NotADirectoryError, PermissionError):  # other errors are faults of the computer
        return {}
    suffix = f'.{kind}'
    return {name.removesuffix(suffix): os.path.join(inside, name) for name in names if name.endswith(suffix)}


@cache
def underlay_registry() -> Registry:
    """Return the one registry of the underlay's interfaces. Its files never change while a program runs, so all
    simulations share it.
    """
    return Registry([os.path.join(underlay_prefix(), 'share')])


_sources: list[Callable[[], Registry | None]] = []


def answer_with(source: Callable[[], Registry | None]) -> None:
    """From now on, call `source` to get the registry of the running program."""
    _sources[:] = [source]


def running_registry() -> Registry | None:
    """Return the registry of the running program; None outside any program, or if its workspace has no interfaces."""
    return _sources[0]() if _sources else None
