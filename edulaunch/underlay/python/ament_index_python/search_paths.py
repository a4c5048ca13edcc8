"""Where packages are searched."""

from __future__ import annotations

from edulaunch.processes import current_process

from .constants import AMENT_PREFIX_PATH_ENV_VAR


def get_search_paths() -> list[str]:
    """The prefixes that are searched, overlays first and the built-in underlay last.

    In ROS these come from AMENT_PREFIX_PATH alone. Here a simulation brings its own list (workspaces and
    prefixes of the session); code outside any simulation gets AMENT_PREFIX_PATH and the underlay.

    :raises EnvironmentError: when there is nothing to search.
    """
    paths = current_process().index.search_paths()
    if not paths:
        raise OSError(f"Environment variable '{AMENT_PREFIX_PATH_ENV_VAR}' is not set or empty")
    return paths
