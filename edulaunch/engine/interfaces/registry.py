"""Finds interface files in share folders, and creates each class once.

If a program runs, the interfaces of its workspace are found, too. This layer does not depend on programs. So the code that runs
programs sets a function that returns the registry of the running program.
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
    """The interfaces in some share folders, and the interfaces of a base registry.

    :param roots: folders laid out as `<package>/{msg,srv,action}/<Name>.{msg,srv,action}`; the first folder with a package is
        used.
    :param base: the registry for packages that are not in `roots`, whose classes are shared. For a workspace, this is the
        underlay's registry.
    :param leave: the packages that are read from `base` although `roots` contains them, too.
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
        """Return whether a package has interfaces; with `kind`, whether it has interfaces of this kind."""
        files = self._files(package)
        if not files and self.base is not None:
            return self.base.has(package, kind)
        return bool(files) if kind is None else kind in files

    def owns(self, package: str) -> bool:
        """Return whether this registry, and not its base, has the interfaces of a package."""
        return bool(self._files(package))

    def names(self, package: str, kind: str) -> list[str]:
        """Return the sorted names of one kind of interface in a package: names('turtlesim', 'srv') -> ['Kill', 'SetPen', ...]."""
        files = self._files(package)
        if not files and self.base is not None:
            return self.base.names(package, kind)
        return sorted(files.get(kind, ()))

    def types(self, kind: str | None = None) -> list[str]:
        """Return all full type names, sorted; with `kind`, only those of this kind."""
        return sorted(
            f'{package}/{each}/{name}'
            for package in self.packages()
            for each in KINDS_OF_INTERFACE
            if kind in (None, each)
            for name in self.names(package, each)
        )

    def homes(self, name: str, kind: str | None = None) -> list[str]:
        """Return the modules that have an interface with this name: homes('Twist') -> ['geometry_msgs.msg']."""
        return [full.rpartition('/')[0].replace('/', '.') for full in self.types(kind) if full.endswith(f'/{name}')]

    def path(self, type_name: str) -> str:
        """Return the path of the file that defines 'pkg/kind/Name'.

        :raises InterfaceError: with the nearest type name, if there is no such file.
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
        """Return the content of the file that defines a type. `ros2 interface show` starts with this content.

        :raises InterfaceError: if the type does not exist.
        """
        path = self.path(type_name)
        with open(path, encoding='utf-8-sig', errors='replace', newline=None) as file:
            return file.read()

    # Specs and classes

    def spec(self, type_name: str) -> InterfaceSpec:
        """Return the definition of a type, or of a part such as 'turtlesim/srv/Spawn_Request'.

        :raises InterfaceError: if the type does not exist or its file is invalid.
        """
        if type_name not in self._specs:
            owner = self._owner(type_name)
            if owner is not self:
                return owner.spec(type_name)
            self._load(type_name)
        return self._specs[type_name]

    def get(self, type_name: str) -> type[Any]:
        """Return the class of 'pkg/kind/Name': a message, a service, an action, or a part of such a type. The first call
        creates the class.

        :raises InterfaceError: if the type does not exist, its file is invalid, or the type contains itself.
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
        """Return all classes that have been created so far, in order of creation. The classes of the base come first."""
        return [*(self.base.classes() if self.base else ()), *self._classes.values()]

    def refresh(self) -> None:
        """Read the folders again on the next use, because files may have been added. Existing classes do not change."""
        self._folders = None
        self._packages.clear()

    # Internal

    def _package_folders(self) -> dict[str, str]:
        """Return the folder of each package. The roots are listed only once, because every import needs this result."""
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
        """Parse a file, and store the specs of everything that the file defines.

        The name of a part consists of the name of its interface, an underscore and a word.
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
        """Return the class of a field's type. An error for an unknown type contains the line of the field."""
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
    """Return the registry of the underlay's interfaces.

    All simulations share this registry, because the underlay's files do not change while edulaunch runs.
    """
    return Registry([os.path.join(underlay_prefix(), 'share')])


_sources: list[Callable[[], Registry | None]] = []


def answer_with(source: Callable[[], Registry | None]) -> None:
    """Set the function that returns the registry of the running program."""
    _sources[:] = [source]


def running_registry() -> Registry | None:
    """Return the registry of the running program. Return None outside any program, or if its workspace has no interfaces."""
    return _sources[0]() if _sources else None
