"""The prefixes in which edulaunch searches for packages."""

from __future__ import annotations

from ._index import existing, index_in_force, own_path
from .constants import AMENT_PREFIX_PATH_ENV_VAR


def get_search_paths() -> list[str]:
    """Return the prefixes of the search, overlays first and the built-in underlay last.

    In ROS, these come from AMENT_PREFIX_PATH alone. Here, a simulation has its own list (the workspaces and prefixes of the
    session) until the program changes the variable.

    :raises EnvironmentError: when the variable is empty.
    """
    path = own_path()
    paths = index_in_force().search_paths() if path is None else existing(path)
    if not (paths or path):
        raise OSError(f"Environment variable '{AMENT_PREFIX_PATH_ENV_VAR}' is not set or empty")
    return paths
