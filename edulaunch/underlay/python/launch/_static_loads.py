"""Launch files loaded only to look inside.

Before a file is included, launch searches it and all files below it for launch arguments, and so again for
each of those. Upstream loads all of them each time, which is quadratic in the depth. Here a file that was
loaded for such a search is kept until the file, the environment or the working directory change. A file that
is really launched is always loaded anew.

Whether files have changed would be asked at each level for all files below it, which is quadratic again. So within one visit, in
which includes of any depth are executed one right after the other, each file is looked at once.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from ._engine import process_state, running_process

if TYPE_CHECKING:
    from .launch_description import LaunchDescription

Stamp = tuple[int, ...]
Files = dict[str, Stamp]
Seen = tuple[Stamp, str, object]


class Loaded:
    """What is known of a description that was only loaded to look inside; it has this as `_loaded`.

    :ivar findings: the arguments below it, None before the first search.
    :ivar files: what was loaded to find them.
    :ivar is_searched: the search goes on just now.
    """

    def __init__(self) -> None:
        self.is_searched = False
        self.findings: list[Any] | None = None
        self.files: Files = {}


def load_once(source: object, location: str, load: Callable[[], LaunchDescription]) -> LaunchDescription | None:
    """What `load()` returns, None when it raises an exception; remembered by the kind of source and location."""
    process = running_process()
    cache: dict[tuple[type, str], tuple[Seen, LaunchDescription | None]] = process.state.setdefault('launch.static_loads', {})
    stamp, folder = _stamp_of(location), os.getcwd()
    process.state.get('launch.looked_at', {})[location] = stamp
    for files in process.state.get('launch.watched_loads', ()):
        files[location] = stamp
    known = cache.get((type(source), location))
    if known is not None and known[0] == (stamp, folder, process.env):
        return known[1]
    environment = dict(process.env)
    try:
        description: Any = load()
        description._loaded = Loaded()
    except Exception:
        description = None
    cache[type(source), location] = (stamp, folder, environment), description
    return description  # type: ignore[no-any-return]


@contextmanager
def loads_watched() -> Iterator[Files]:
    """Collects what :func:`load_once` is asked for inside."""
    watched: list[Files] = process_state('launch.watched_loads', list)
    files: Files = {}
    watched.append(files)
    try:
        yield files
    finally:
        watched.pop()


@contextmanager
def one_visit() -> Iterator[None]:
    """Inside, :func:`is_current` looks at each file once."""
    state = running_process().state
    state['launch.looked_at'] = {}
    try:
        yield
    finally:
        state.pop('launch.looked_at', None)  # a visit may have held another one


def is_current(files: Files) -> bool:
    """Whether all files still are as they were."""
    looked_at: Files = running_process().state.get('launch.looked_at', {})
    for location, stamp in files.items():
        now = looked_at.get(location)
        if now is None:
            now = looked_at[location] = _stamp_of(location)
        if now != stamp:
            return False
    return True


def _stamp_of(location: str) -> Stamp:
    try:
        status = os.stat(location)
    except OSError:
        return ()
    return status.st_mtime_ns, status.st_size, status.st_ino
