"""Elements, substitutions and formats of installed packages, found through entry points.

Finding entry points takes longer than parsing a launch file, so it happens only when a name is unknown.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from typing import Any

LAUNCH_EXTENSION_GROUP = 'launch.frontend.launch_extension'
PARSER_GROUP = 'launch.frontend.parser'


def entry_points_of(group: str) -> Iterator[Any]:
    """Return the entry points of a group in all installed packages."""
    import importlib.metadata

    found: Any = importlib.metadata.entry_points()
    return iter(found.select(group=group) if hasattr(found, 'select') else found.get(group, ()))


def load_launch_extensions() -> None:
    """Import every module with launch extensions. A module that cannot be imported causes a warning."""
    for entry_point in entry_points_of(LAUNCH_EXTENSION_GROUP):
        try:
            entry_point.load()
        except Exception:
            warnings.warn(f'Failed to load the launch extension: {entry_point.name}', stacklevel=2)


def load_parsers(known: dict[str, Any]) -> dict[str, Any]:
    """Return the `known` parsers, followed by the parsers of installed packages, by name. A failing import causes a warning."""
    parsers = dict(known)
    for entry_point in entry_points_of(PARSER_GROUP):
        if entry_point.name in parsers:
            continue
        try:
            parsers[entry_point.name] = entry_point.load()
        except Exception:
            warnings.warn(f'Failed to load the parser implementation: {entry_point.name}', stacklevel=2)
    return parsers
