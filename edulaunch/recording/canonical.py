"""The part of a recording that its digest covers: what happened, without where files lie on this machine."""

from __future__ import annotations

from typing import Any

TEXT_PARTS = ('launch', 'processes', 'output', 'logs', 'notes', 'parameters')
TEXT_TYPES = ('rcl_interfaces/msg/Log', 'rcl_interfaces/msg/ParameterEvent', 'std_msgs/msg/String')
"""Messages that tell of files: log lines, parameters that name a share folder, plain texts."""


def canonical(content: dict[str, Any]) -> dict[str, Any]:
    """The content with the folders named in `roots` (workspaces, the underlay, the launch file's folder, temporary files)
    replaced by short names wherever a text mentions them.
    """
    roots = sorted(content['roots'], key=lambda root: -len(root[0]))
    short = {part: _shorten(content[part], roots) for part in TEXT_PARTS}
    topics = [
        {**topic, 'messages': _shorten(topic['messages'], roots)} if topic['type'] in TEXT_TYPES else topic
        for topic in content['topics']
    ]
    return {**content, **short, 'topics': topics, 'roots': []}


def _shorten(value: Any, roots: list[list[str]]) -> Any:
    if isinstance(value, str):
        for path, name in roots:
            if path in value:
                value = value.replace(path, name)
        return value
    if isinstance(value, dict):
        return {key: _shorten(item, roots) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_shorten(item, roots) for item in value]
    return value
