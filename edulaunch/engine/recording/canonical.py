"""The part of a recording that its digest covers: all events, without the paths of files on this machine."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

TEXT_PARTS = ('launch', 'processes', 'logs', 'notes', 'parameters', 'calls')
ONLY_FRAMES = ('tf2_msgs/', 'geometry_msgs/', 'sensor_msgs/', 'nav_msgs/')
"""Packages whose messages have no strings except frame names. They are not searched for paths, because there are too many
messages.
"""
_BEGINS = r'(?:(?<![\w/.@+~-])|(?<=file://)|(?<=\dm)|(?<=\\n))'
"""Where a path may begin: not inside another path, but after a colour code or an escaped line end."""
_ENDS = r'(?![\w+-]|\.\w)'
_LIBRARY_FRAME = re.compile(r'(?:\[[^]]*\] )?  File "@(?:stdlib|site-packages)[/"]')
_ADDRESS = re.compile(r'\bat 0x[0-9a-fA-F]{6,16}\b')
"""The place of an object in memory, which the default `repr` shows."""
_SOURCE_LINE = re.compile(r'(?:\[[^]]*\] )?    ')


def canonical(content: dict[str, Any]) -> dict[str, Any]:
    """Return the content with everything replaced or removed that differs between machines or versions.

    In every string, short names replace the folders in `roots`. These are workspaces, the package edulaunch, the launch file's
    folder, Python's folders and temporary files. The numbers of memory addresses are removed, and so are the frames of libraries
    in tracebacks.
    """
    shorten = _shortener(content['roots'])
    short = {part: shorten(content[part]) for part in TEXT_PARTS}
    topics = [{**topic, 'messages': shorten(topic['messages'])} if _has_text(topic) else topic for topic in content['topics']]
    output = _without_library_frames(shorten(content['output']))
    short |= {part: shorten(content.get(part) or []) for part in ('facts', 'descriptors')}
    short['beside'] = shorten(content.get('beside') or {})
    return {**content, **short, 'output': output, 'topics': topics, 'roots': []}


def _has_text(topic: dict[str, Any]) -> bool:
    return not topic['type'].startswith(ONLY_FRAMES) and any(map(_holds_text, topic['messages'][:1]))


def _holds_text(value: Any) -> bool:
    return isinstance(value, str) or (isinstance(value, (list, tuple)) and any(map(_holds_text, value)))


def _shortener(roots: list[list[str]]) -> Callable[[Any], Any]:
    """Return a function that replaces the roots in all strings of plain data.

    A root is replaced only where a path begins: '/tmp' is replaced in '/tmp/tmpabc', but not in '/home/tmp/x'.
    """
    names: dict[str, str] = {}
    for path, name in roots:
        names.setdefault(path.rstrip('/'), name)
    names.pop('', None)
    longest_first = sorted(names, key=lambda path: (-len(path), path))
    any_root = re.compile(f'{_BEGINS}(?:{"|".join(map(re.escape, longest_first))}){_ENDS}' if names else '(?!)')

    def shorten(value: Any) -> Any:
        if isinstance(value, str):
            value = any_root.sub(lambda found: names[found[0]], value) if '/' in value else value
            return _ADDRESS.sub('at 0x', value) if ' 0x' in value else value
        if isinstance(value, dict):
            return {key: shorten(item) for key, item in value.items()}
        if isinstance(value, (list, tuple)):
            return [shorten(item) for item in value]
        return value

    return shorten


def _without_library_frames(rows: list[list[Any]]) -> list[list[Any]]:
    """Return output rows (time, process, stream, string) without library frames.

    A traceback may be in one row or, as launch prints it, in one row for each line.
    """
    within: dict[str, bool] = {}
    found = []
    for *before, text in rows:
        kept = [line for line in text.splitlines(keepends=True) if not _is_of_library(line, before[1], within)]
        if kept or not text:
            found.append([*before, ''.join(kept)])
    return found


def _is_of_library(line: str, process: str, within: dict[str, bool]) -> bool:
    within[process] = bool(_LIBRARY_FRAME.match(line)) or (within.get(process, False) and bool(_SOURCE_LINE.match(line)))
    return within[process]
