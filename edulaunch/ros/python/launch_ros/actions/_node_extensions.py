"""Extensions of installed packages that change each started node. They are classes in the entry points of
`launch_ros.node_action`.
"""

from __future__ import annotations

import os
import sys
from functools import lru_cache
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

    from .node import Node

GROUP = 'launch_ros.node_action'
FOLDER_ENDINGS = ('.dist-info', '.egg-info')


class NodeActionExtension:
    """The base class of extensions for nodes. `NAME` is the name of the extension's entry point."""

    NAME: str | None = None
    EXTENSION_POINT_VERSION = '0.1'

    def __init__(self) -> None:
        from ..utilities.plugin_support import satisfies_version

        satisfies_version(self.EXTENSION_POINT_VERSION, '^0.1')

    def prepare_for_execute(
        self, context: LaunchContext, ros_specific_arguments: dict[str, Any], node_action: Node
    ) -> tuple[list[Any], dict[str, Any]]:
        """Return further words of the command line, and the new value of the local variable `ros_specific_arguments`.

        This method is called before a node starts.
        """
        return [], ros_specific_arguments


def get_extensions(logger: Any) -> dict[str, NodeActionExtension]:
    """Return an instance of each installed extension, by name. An extension that cannot be created causes a warning."""
    extensions: dict[str, NodeActionExtension] = {}
    if not _are_announced(tuple(sys.path)):
        return extensions
    from launch.frontend.extensions import entry_points_of

    for entry_point in sorted(entry_points_of(GROUP), key=lambda point: str(point.name)):
        try:
            extension_class = entry_point.load()
        except Exception as error:
            logger.warning(f"Failed to load entry point '{entry_point.name}': {error}")
            continue
        instantiate_extension(GROUP, entry_point.name, extension_class, extensions, logger)
    return extensions


def instantiate_extension(
    group_name: str,
    extension_name: str,
    extension_class: Any,
    extensions: dict[str, NodeActionExtension],
    logger: Any,
    *,
    unique_instance: bool = False,
) -> NodeActionExtension | None:
    """Return the extension of this name in `extensions`; create and store it if it is missing.

    If that fails, log a warning and return None.

    :param unique_instance: whether to create a new extension each time, without storing it.
    """
    if not unique_instance and extension_name in extensions:
        return extensions[extension_name]
    try:
        extension: NodeActionExtension = extension_class()
    except Exception as error:
        logger.warning(f"Failed to instantiate '{group_name}' extension '{extension_name}': {error}")
        return None
    if not unique_instance:
        extension.NAME = extension_name
        extensions[extension_name] = extension
    return extension


@lru_cache(maxsize=8)
def _are_announced(folders: tuple[str, ...]) -> bool:
    """Return whether any installed package declares the group. A query of `importlib.metadata` takes thirty times as long."""
    return any(
        GROUP.encode() in _entry_points_text(os.path.join(folder, name)) for folder in folders for name in _packages(folder)
    )


def _packages(folder: str) -> list[str]:
    try:
        return [name for name in os.listdir(folder or '.') if name.endswith(FOLDER_ENDINGS)]
    except OSError:
        return []


def _entry_points_text(folder: str) -> bytes:
    try:
        with open(os.path.join(folder, 'entry_points.txt'), 'rb') as file:
            return file.read()
    except OSError:
        return b''
