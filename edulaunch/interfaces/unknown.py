"""Words for an interface that does not exist."""

from __future__ import annotations

from typing import TYPE_CHECKING

from edulaunch.errors import InterfaceError
from edulaunch.interfaces.modules import homes_of
from edulaunch.nearest import did_you_mean

if TYPE_CHECKING:
    from edulaunch.interfaces.registry import Registry


def unknown_type(registry: Registry, type_name: str) -> InterfaceError:
    """The error for a type name that nothing defines, with the nearest one that exists."""
    return InterfaceError(f"unknown interface '{type_name}'", help=type_help(registry, type_name))


def type_help(registry: Registry, type_name: str) -> str | None:
    """What may have been meant by a wrong type name."""
    package, _, name = type_name.partition('/')
    kind, _, name = name.rpartition('/')
    elsewhere = homes_of(registry, name, kind or None)
    if elsewhere:
        return f'{name} is in {" and ".join(elsewhere)}'
    if not registry.has(package):
        return (
            did_you_mean(package, registry.packages())
            or 'no package with interfaces has this name: is its workspace built and sourced?'
        )
    return did_you_mean(type_name, registry.types())
