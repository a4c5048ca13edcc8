"""Launch files loaded only to look inside.

Before a file is included, launch searches it and all files below it for launch arguments, and so again for
each of those. Upstream loads all of them each time, which is quadratic in the depth. Here a file that was
loaded for such a search is kept until the file, the environment or the working directory change. A file that
is really launched is always loaded anew.
"""
from __future__ import annotations

import os
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ._engine import environment, process_state

if TYPE_CHECKING:
    from .launch_description import LaunchDescription

Seen = tuple[object, ...]


def load_once(
    source: object, location: str, load: Callable[[], LaunchDescription]
) -> LaunchDescription | None:
    """What `load()` returns, None when it raises an exception; remembered by the kind of source and location.
    """
    cache: dict[tuple[type, str], tuple[Seen, LaunchDescription | None]] = process_state(
        'launch.static_loads', dict
    )
    seen = _state_of(location)
    known = cache.get((type(source), location))
    if known is not None and known[0] == seen:
        return known[1]
    try:
        description: Any = load()
    except Exception:
        description = None
    cache[type(source), location] = (seen, description)
    return description  # type: ignore[no-any-return]


def _state_of(location: str) -> Seen:
    try:
        status = os.stat(location)
        stamp: Seen = (status.st_mtime_ns, status.st_size, status.st_ino)
    except OSError:
        stamp = ()
    return stamp, os.getcwd(), dict(environment())
