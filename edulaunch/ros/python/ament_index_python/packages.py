"""Functions that find packages by name."""

from __future__ import annotations

import os
import re
import warnings
from typing import TYPE_CHECKING

from edulaunch.engine.facts import with_facts
from edulaunch.engine.processes import current_process

from ._index import index_in_force
from .search_paths import get_search_paths

if TYPE_CHECKING:
    from pathlib import Path

_NAME = re.compile(r'[a-zA-Z0-9][a-zA-Z0-9_-]+')


class PackageNotFoundError(KeyError):
    """No prefix of the search path contains a package with that name."""


def get_package_prefix(package_name: str) -> str:
    """Return the install prefix of a package.

    :raises ValueError: when `package_name` is not a valid package name.
    :raises PackageNotFoundError: when there is no such package.
    """
    if not _NAME.fullmatch(package_name):
        raise ValueError(f"'{package_name}' is not a valid package name")
    prefix = index_in_force().prefix(package_name) or _left_out_by_launch(package_name)
    if prefix is None:
        raise _not_found(package_name)
    return prefix


def get_package_share_directory(package_name: str, print_warning: bool = True) -> str:
    """Return `<prefix>/share/<package>`. If that folder does not exist, log a warning.

    :raises ValueError: when `package_name` is not a valid package name.
    :raises PackageNotFoundError: when there is no such package.
    """
    return _share(package_name, 'directory' if print_warning else None)


def get_package_share_path(package_name: str, print_warning: bool = True) -> Path:
    """Return the result of :func:`get_package_share_directory` as a `pathlib.Path`.

    A program can have its own copy of `pathlib`. The class of the returned path comes from this copy.
    """
    import pathlib  # imported here, because it takes 4 ms

    of_program = current_process().loader.modules.get('pathlib', pathlib)
    path: Path = of_program.Path(_share(package_name, 'path' if print_warning else None))
    return path


def get_packages_with_prefixes() -> dict[str, str]:
    """Return the install prefix of each package, by package name."""
    get_search_paths()
    return index_in_force().packages()


def _share(package_name: str, called: str | None) -> str:
    """Return the share folder. If it is missing and `called` (the name of the public function) is given, log a warning."""
    path = os.path.join(get_package_prefix(package_name), 'share', package_name)
    if called is not None and not os.path.exists(path) and _left_out_by_launch(package_name) is None:
        warnings.warn(f'Share {called} for {package_name} ({path}) does not exist.', stacklevel=3)
    return path


def _left_out_by_launch(package_name: str) -> str | None:
    """Return the share folder of a well-known package that is not installed, or None.

    A launch file continues without such a package, but a program gets the error.
    """
    process = current_process()
    if 'launch.process_counter' not in process.state:
        return None
    is_known = 'launch.assumptions' not in process.state and process.index.absent(package_name) is not None
    return process.index.absent_prefix if is_known else None


def _not_found(package_name: str) -> PackageNotFoundError:
    from edulaunch.ros.sources.missing import missing_package

    error = PackageNotFoundError(f"package '{package_name}' not found, searching: {get_search_paths()}")
    return with_facts(error, **missing_package(index_in_force(), package_name, current_process().cwd))
