"""Elements, substitutions and formats that installed packages add, found through entry points.

Looking entry points up costs more than parsing a launch file, so this happens when something unknown is met first.
"""
from __future__ import annotations

import warnings
from collections.abc import Iterator
from typing import Any

LAUNCH_EXTENSION_GROUP = 'launch.frontend.launch_extension'
PARSER_GROUP = 'launch.frontend.parser'


def entry_points_of(group: str) -> Iterator[Any]:
    """The entry points of a group, of all installed packages."""
    from . import parser
    found = parser.importlib_metadata.entry_points()
    return iter(found.select(group=group) if hasattr(found, 'select') else found.get(group, ()))


def load_launch_extensions() -> None:
    """Import every module that announces launch extensions, once; one that cannot be imported gives a warning."""
    from .parser import Parser
    if Parser.extensions_loaded:
        return
    Parser.extensions_loaded = True
    for entry_point in entry_points_of(LAUNCH_EXTENSION_GROUP):
        try:
            entry_point.load()
        except Exception:
            warnings.warn(f'Failed to load the launch extension: {entry_point.name}', stacklevel=2)


def load_parser_extensions(known: dict[str, type]) -> dict[str, type]:
    """Parsers of installed packages by name, `known` ones first; one that cannot be imported gives a warning."""
    parsers = dict(known)
    for entry_point in entry_points_of(PARSER_GROUP):
        if entry_point.name in parsers:
            continue
        try:
            parsers[entry_point.name] = entry_point.load()
        except Exception:
            warnings.warn(f'Failed to load the parser implementation: {entry_point.name}', stacklevel=2)
    return parsers
