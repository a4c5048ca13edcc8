"""The program rviz2, without its window."""

from __future__ import annotations

import os
import sys
from typing import Any, NamedTuple

import rclpy
from rclcpp_like import CppNode, run_program
from rclpy.utilities import remove_ros_args
from tf2_ros import Buffer, TransformListener


class View(NamedTuple):
    """The displays that a config requests."""

    fixed_frame: str = 'map'
    displays: tuple[str, ...] = ()
    shows_tf: bool = False
    view_type: str = 'Orbit'


def read_view(path: str) -> View:
    """Return the view that a config file describes.

    :raises OSError: when the file cannot be read.
    :raises ValueError: when the file is not an RViz config.
    """
    import yaml

    with open(path, encoding='utf-8') as stream:
        try:
            data = yaml.safe_load(stream)
        except (yaml.YAMLError, UnicodeDecodeError) as error:
            raise ValueError(' '.join(str(error).split())) from error
    if not isinstance(data, dict) or not isinstance(data.get('Visualization Manager'), dict):
        raise ValueError("a mapping with the key 'Visualization Manager' was expected at the top")
    manager = data['Visualization Manager']
    displays = [display for display in _flat(manager.get('Displays')) if display.get('Enabled', True)]
    view = _mapping(_mapping(manager.get('Views')).get('Current'))
    return View(
        fixed_frame=str(_mapping(manager.get('Global Options')).get('Fixed Frame', 'map')),
        displays=tuple(str(display.get('Name', display.get('Class', '?'))) for display in displays),
        shows_tf=any(display.get('Class') == 'rviz_default_plugins/TF' for display in displays),
        view_type=str(view.get('Class', 'rviz_default_plugins/Orbit')).rpartition('/')[2],
    )


def _flat(displays: Any) -> list[dict[str, Any]]:
    """Return the displays, including those inside groups."""
    found: list[dict[str, Any]] = []
    for display in displays if isinstance(displays, list) else []:
        if isinstance(display, dict):
            found.extend([display, *_flat(display.get('Displays'))])
    return found


def _mapping(value: Any) -> dict[str, Any]:
    return value if isinstance(value, dict) else {}


class Rviz(CppNode):
    """Loads a config, prints its displays, and listens to tf if the config has a TF display."""

    def __init__(self, config: str | None, fixed_frame: str | None) -> None:
        super().__init__('rviz')
        view = View(displays=('Grid',)) if config is None else self._load(config)
        if fixed_frame is not None:
            view = view._replace(fixed_frame=fixed_frame)
        log = self.get_logger()
        displays = ', '.join(view.displays) or 'none'
        log.info(f"View: {view.view_type}, fixed frame '{view.fixed_frame}', displays: {displays}")
        log.info('edulaunch opens no RViz window: the pictures come from the recording')
        if view.shows_tf:
            self._buffer = Buffer()
            self._listener = TransformListener(self._buffer, self)

    def _load(self, config: str) -> View:
        log = self.get_logger()
        try:
            view = read_view(config)
        except OSError as error:
            log.error(f"Could not load display config '{config}': {error.strerror}")
        except ValueError as error:
            log.error(f"Could not load display config '{config}': it is not an RViz config: {error}")
        else:
            log.info(f"Loaded display config '{os.path.basename(config)}'")
            return view
        return View(displays=('Grid',))


def main() -> None:
    """Run the program. It accepts the options of rviz2, but the options for the window have no effect."""
    import argparse

    parser = argparse.ArgumentParser(prog='rviz2')
    parser.add_argument('-d', '--display-config', help='config file (.rviz) to load')
    parser.add_argument('-f', '--fixed-frame', help="fixed frame, in place of the config file's")
    parser.add_argument('-t', '--splash-screen', help='accepted, without effect')
    for flag in ('-o', '--ogre-log'), ('-l', '--ogre-log-to-console'), ('--fullscreen',):
        parser.add_argument(*flag, action='store_true', help='accepted, without effect')
    options = parser.parse_args(remove_ros_args(sys.argv)[1:])
    sys.exit(run_program(lambda: rclpy.spin(Rviz(options.display_config, options.fixed_frame))))
