"""Functions that find interfaces and their files."""

from __future__ import annotations

from collections.abc import Iterable

from edulaunch.engine.interfaces import current_registry
from edulaunch.errors import InterfaceError


def get_interface_packages() -> list[str]:
    """Return the names of all packages with interfaces."""
    return current_registry().packages()


def get_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the interfaces of each package, such as 'msg/Name' and 'srv/Name'.

    :param package_names: the packages. By default, all packages with interfaces.
    :raises LookupError: for a package without interfaces.
    """
    return _of_kinds(package_names, ('action', 'msg', 'srv'))


def get_message_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the messages of each package; see :func:`get_interfaces`."""
    return _of_kinds(package_names, ('msg',))


def get_service_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the services of each package; see :func:`get_interfaces`."""
    return _of_kinds(package_names, ('srv',))


def get_action_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Return the actions of each package; see :func:`get_interfaces`."""
    return _of_kinds(package_names, ('action',))


def get_interface_path(interface_name: str) -> str:
    """Return the path of the file that defines 'pkg/msg/Name'.

    :raises ValueError: when the name has another form.
    :raises LookupError: for an unknown interface.
    """
    parts = interface_name.removesuffix('.msg').removesuffix('.srv').removesuffix('.action').split('/')
    if len(parts) != 3 or not all(parts):
        raise ValueError(f"Invalid name '{interface_name}'. Expected three parts separated by '/'")
    try:
        return current_registry().path('/'.join(parts))
    except InterfaceError as error:
        raise LookupError(f"Could not find the interface '{interface_name}': {error}") from None


def _of_kinds(package_names: Iterable[str], kinds: tuple[str, ...]) -> dict[str, list[str]]:
    registry, wanted = current_registry(), list(package_names)
    for package in wanted:
        if not registry.has(package):
            raise LookupError(f"Unknown package '{package}'")
    found = {
        package: [f'{kind}/{name}' for kind in kinds for name in registry.names(package, kind)]
        for package in wanted or registry.packages()
    }
    return {package: names for package, names in found.items() if names}
