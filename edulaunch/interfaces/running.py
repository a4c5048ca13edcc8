"""Whose interfaces count: those of the running program's workspace, where there is one.

This layer knows no programs. Whoever runs them says here, once, how to find the registry of the one that runs.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.interfaces.registry import Registry

_sources: list[Callable[[], Registry | None]] = []


def answer_with(source: Callable[[], Registry | None]) -> None:
    """Ask `source` for the registry of the running program from now on."""
    _sources[:] = [source]


def running_registry() -> Registry | None:
    """The registry of the running program; None outside any, or when its workspace has no interfaces."""
    return _sources[0]() if _sources else None
