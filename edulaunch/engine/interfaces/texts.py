"""Interface definitions as strings. Recordings store them, so that every computer can read messages of a student's own types."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from edulaunch.engine.interfaces.registry import KINDS_OF_INTERFACE, Registry
from edulaunch.errors import InterfaceError

if TYPE_CHECKING:
    from edulaunch.engine.interfaces.spec import InterfaceSpec


class TextRegistry(Registry):
    """The interfaces with the given definitions, and the interfaces of a base registry.

    :param texts: the content of each interface file, by type name such as 'my_interfaces/msg/Num'.
    :param base: the registry for all other packages.
    """

    def __init__(self, texts: Mapping[str, str], base: Registry | None = None) -> None:
        super().__init__((), base)
        self._texts = dict(texts)
        for name in sorted(self._texts):
            package, kind, short = name.split('/')
            self._packages.setdefault(package, {}).setdefault(kind, {})[short] = f'{name}.{kind}'

    def text(self, type_name: str) -> str:
        """Return the definition of a type.

        :raises InterfaceError: if the type does not exist.
        """
        if type_name in self._texts:
            return self._texts[type_name]
        return super().text(type_name)

    def refresh(self) -> None:
        """Do nothing, because the definitions do not change."""

    def _files(self, package: str) -> dict[str, dict[str, str]]:
        return self._packages.get(package, {})

    def _package_folders(self) -> dict[str, str]:
        return dict.fromkeys(self._packages, '')


def texts_of(registry: Registry, names: Iterable[str]) -> dict[str, str]:
    """Return the definitions of the named types and of all types that they contain, by type name.

    Leave out the types that the registry takes from its base, such as the types of the underlay.

    :param names: type names; a part such as 'pkg/srv/Catch_Request' means the whole type.
    """
    found: dict[str, str] = {}
    waiting = sorted({*map(_whole, names)}, reverse=True)
    while waiting:
        name = waiting.pop()
        package = name.partition('/')[0]
        if name in found or not registry.owns(package):
            continue
        try:
            parts = [registry.spec(part) for part in _parts(registry, name)]
        except InterfaceError:
            continue  # the type does not exist or cannot be read, so no program has used it
        found[name] = registry.text(name)
        waiting += [_whole(nested) for part in parts for nested in _nested(part)]
    return dict(sorted(found.items()))


def _whole(name: str) -> str:
    package, _, rest = name.partition('/')
    kind, _, short = rest.partition('/')
    return f'{package}/{kind}/{short.partition("_")[0]}' if kind in KINDS_OF_INTERFACE else name


def _parts(registry: Registry, name: str) -> list[str]:
    from edulaunch.engine.interfaces.services import parts_of

    return list(parts_of(registry.spec(name)))


def _nested(spec: InterfaceSpec) -> list[str]:
    """Return the type names of the fields that are messages; a service or an action has no fields, because its parts are
    separate.
    """
    return [field.type.base for field in getattr(spec, 'fields', ()) if field.type.kind is None]
