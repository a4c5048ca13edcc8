"""The part of an RViz config file that decides what RViz listens to."""

from __future__ import annotations

from typing import Any, NamedTuple


class View(NamedTuple):
    """What a config asks to see."""

    fixed_frame: str = 'map'
    displays: tuple[str, ...] = ()
    shows_tf: bool = False
    view_type: str = 'Orbit'


def read_view(path: str) -> View:
    """Read a config file.

    :raises OSError: it cannot be read.
    :raises ValueError: it is not an RViz config.
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
    """The displays, those inside groups too."""
    found: list[dict[str, Any]] = []
    for display in displays if isinstance(displays, list) else []:
        if isinstance(display, dict):
            found.extend([display, *_flat(display.get('Displays'))])
    return found


def _mapping(value: Any) -> dict[str, Any]:
    return value if isinstance(value, dict) else {}
