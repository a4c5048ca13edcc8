"""What a confined run may read: the system's programs, Python with its packages, the engine; nothing of the grader."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence

from edulaunch.underlay_place import engine_folder

from .catalogue import rubrics_folder
from .submission import Submission

SYSTEM = (
    *('/usr', '/bin', '/sbin', '/lib', '/lib32', '/lib64', '/libx32', '/opt'),
    *('/etc/ld.so.cache', '/etc/ld.so.preload', '/etc/localtime', '/etc/timezone', '/etc/passwd', '/etc/group'),
    *('/etc/nsswitch.conf', '/etc/hosts', '/etc/os-release', '/etc/mime.types', '/etc/fonts', '/etc/alternatives'),
)


def readable_by_all(path: Sequence[str]) -> tuple[list[str], list[str]]:
    """(what may be read with all below it, folders that may be listed only), for every run.

    :param path: where Python looks for modules.
    """
    engine = os.path.realpath(engine_folder())
    own = os.path.dirname(os.path.abspath(__file__))
    hidden = [os.path.realpath(each) for each in (own, rubrics_folder())]
    roots = [sys.prefix, sys.base_prefix, engine, *SYSTEM, *(each for each in path if not _is_checkout(each))]
    read: dict[str, None] = {}
    listed: dict[str, None] = {}
    seen: set[str] = set()
    for root in roots:
        for place, is_whole in _beneath(os.path.realpath(root), hidden, seen):
            (read if is_whole else listed).setdefault(place)
    return list(read), list(listed)


def readable_by_run(submission: Submission, workspaces: Sequence[str]) -> list[str]:
    """What the run of a submission may read besides: its package and workspaces; a launch file alone only itself."""
    return [submission.package.path if submission.package else submission.file, *workspaces]


def _is_checkout(path: str) -> bool:
    """Whether it is the source tree of the course, which holds the solutions: of it the engine is read, and no more."""
    return os.path.isdir(os.path.join(path, 'edulaunch')) and os.path.isdir(os.path.join(path, 'solutions'))


def _beneath(place: str, hidden: Sequence[str], seen: set[str]) -> Iterator[tuple[str, bool]]:
    """(place, whether with all below it) so that everything in `place` can be read but what is hidden. Links are resolved."""
    if place in seen or any(place == each or place.startswith(os.path.join(each, '')) for each in hidden):
        return
    seen.add(place)
    if not any(each.startswith(os.path.join(place, '')) for each in hidden):
        yield place, True
        return
    yield place, False
    for name in sorted(os.listdir(place)):
        yield from _beneath(os.path.realpath(os.path.join(place, name)), hidden, seen)
