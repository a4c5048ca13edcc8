"""Resources: the marker files below `share/ament_index/resource_index/<type>/<name>` of each prefix."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Literal

from ._index import index_in_force
from .constants import RESOURCE_INDEX_SUBFOLDER
from .search_paths import get_search_paths


class InvalidResourceTypeNameError(ValueError):
    """The name of a resource type contains a path separator."""


class InvalidResourceNameError(ValueError):
    """The name of a resource contains a path separator."""


def name_is_invalid(resource_name: str) -> bool:
    """Return whether a name contains a path separator, which could lead out of the index folder."""
    return '/' in resource_name or '\\' in resource_name


def get_resource(resource_type: str, resource_name: str) -> tuple[str, str]:
    """Return the content of a resource file, and the prefix that contains it.

    :raises LookupError: when the resource does not exist.
    :raises InvalidResourceTypeNameError, InvalidResourceNameError: for a name that contains a slash or a backslash.
    """
    _check(resource_type, resource_name)
    for prefix in _prefixes():
        path = os.path.join(prefix, RESOURCE_INDEX_SUBFOLDER, resource_type, resource_name)
        if os.path.isfile(path):
            with open(path, encoding='utf-8') as stream:
                return stream.read(), prefix
    raise LookupError(f"Could not find the resource '{resource_name}' of type '{resource_type}'")


def has_resource(resource_type: str, resource_name: str) -> str | Literal[False]:
    """Return the first prefix that contains the resource, or False."""
    _check(resource_type, resource_name)
    relative = os.path.join(RESOURCE_INDEX_SUBFOLDER, resource_type, resource_name)
    return next((prefix for prefix in _prefixes() if os.path.isfile(os.path.join(prefix, relative))), False)


def get_resources(resource_type: str) -> dict[str, str]:
    """Return the names of all resources of a type, each with the first prefix that contains it."""
    _check(resource_type, None)
    found: dict[str, str] = {}
    if resource_type == 'packages':
        found.update(index_in_force().packages())
    for prefix in _prefixes():
        for entry in _entries(os.path.join(prefix, RESOURCE_INDEX_SUBFOLDER, resource_type)):
            if not entry.is_dir() and not entry.name.startswith('.'):
                found.setdefault(entry.name, prefix)
    return found


def get_resource_types() -> set[str]:
    """Return the names of all resource types."""
    folders = [os.path.join(prefix, RESOURCE_INDEX_SUBFOLDER) for prefix in _prefixes()]
    return {entry.name for folder in folders for entry in _entries(folder) if entry.is_dir() and not entry.name.startswith('.')}


def _check(resource_type: str, resource_name: str | None) -> None:
    assert resource_type, 'The resource type must not be empty'
    assert resource_name is None or resource_name, 'The resource name must not be empty'
    if name_is_invalid(resource_type):
        raise InvalidResourceTypeNameError(f"Resource type '{resource_type}' is invalid")
    if resource_name is not None and name_is_invalid(resource_name):
        raise InvalidResourceNameError(f"Resource name '{resource_name}' is invalid")


def _prefixes() -> list[str]:
    """Return the search path. The marker files of all source packages exist when the function returns."""
    index = index_in_force()
    for package in index.packages():
        index.prefix(package)
    return get_search_paths()


def _entries(folder: str) -> Iterator[os.DirEntry[str]]:
    try:
        with os.scandir(folder) as entries:
            yield from sorted(entries, key=lambda entry: entry.name)
    except OSError:
        return  # most prefixes lack most types of resources
