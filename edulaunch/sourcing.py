"""The counterpart of sourcing ROS 2's setup files: putting the underlay on the path, and telling what overlays are."""

from __future__ import annotations

import os
import sys
from importlib.machinery import PathFinder

from edulaunch.errors import ForeignRosError
from edulaunch.underlay_place import put_on_prefix_path, underlay_python


def source() -> None:
    """Make `launch`, `rclpy`, `tf2_ros`, `geometry_msgs` and the other ROS packages importable. Doing it twice is doing it once.

    :raises ForeignRosError: when an `rclpy` that is not ours can be imported already; nothing is changed then.
    """
    from edulaunch.interfaces.importer import installed_registry

    place = underlay_python()
    if place in sys.path and installed_registry() is not None:
        return
    foreign = _foreign_rclpy(place)
    if foreign is not None:
        raise ForeignRosError(
            f'a ROS 2 installation is on the Python path: rclpy at {foreign}. edulaunch does not shadow it.',
            help='open a terminal in which ROS 2 is not sourced (check: printenv PYTHONPATH), or a fresh virtual environment',
        )
    from edulaunch.interfaces import install

    if place not in sys.path:
        sys.path.insert(0, place)
    install()
    put_on_prefix_path()


def _foreign_rclpy(ours: str) -> str | None:
    """Where an rclpy of somebody else is, if there is one."""
    loaded = sys.modules.get('rclpy')
    spec = PathFinder.find_spec('rclpy') if loaded is None else loaded.__spec__
    if spec is None or spec.origin is None or spec.origin.startswith(ours + os.sep):
        return None
    return os.path.dirname(spec.origin)
