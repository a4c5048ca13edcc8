"""The folders and the environment of runs: where Python finds modules, and which paths every run may read."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence

from edulaunch.engine.underlay_place import engine_folder


def environment(home: str) -> dict[str, str]:
    """Return the environment of a run: the search path for programs, its private folder, and a few other variables.

    :param home: the private folder of the run.
    """
    return {
        'PATH': os.environ.get('PATH', os.defpath),
        'HOME': home,
        'TMPDIR': home,
        'LANG': 'C.UTF-8',
        'USER': 'student',
        'PYTHONHASHSEED': '0',  # the order of a set must not affect a mark
        'OPENBLAS_NUM_THREADS': '1',
        'OMP_NUM_THREADS': '1',
    }


def import_path() -> list[str]:
    """Return the module search path of the child.

    This is the path of this process, limited to Python's own folders and to folders with modules that the engine needs.
    """
    engine = os.path.dirname(engine_folder())
    here = os.getcwd()
    known = [path for path in sys.path if path and os.path.abspath(path) != here and (_is_of_python(path) or _needed_in(path))]
    return known if engine in known else [engine, *known]


PACKAGES = ('site-packages', 'dist-packages')
NEEDED = ('greenlet', 'yaml', '_yaml', 'numpy', 'numpy.libs', 'matplotlib', 'rosbags', 'transforms3d', 'urdf_parser_py')
SYSTEM = (
    *('/usr', '/bin', '/sbin', '/lib', '/lib32', '/lib64', '/libx32', '/opt'),
    *('/etc/ld.so.cache', '/etc/ld.so.preload', '/etc/localtime', '/etc/timezone', '/etc/passwd', '/etc/group'),
    *('/etc/nsswitch.conf', '/etc/hosts', '/etc/os-release', '/etc/mime.types', '/etc/fonts', '/etc/alternatives'),
)


def readable_by_all(path: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return two lists of paths that every run may read.

    The first list contains paths with everything below them, and the second list contains folders whose names the run may
    only list.

    :param path: the module search path.
    """
    roots, hidden = shown_to_all(path)
    read: dict[str, None] = {}
    listed: dict[str, None] = {}
    seen: set[str] = set()
    for root in roots:
        for place, is_whole in _beneath(os.path.realpath(root), hidden, seen):
            (read if is_whole else listed).setdefault(place)
    for each in path:
        if not _is_of_python(each) and _needed_in(each):
            listed.setdefault(os.path.realpath(each))
    return list(read), list(listed)


def shown_to_all(path: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return two lists: the paths that every run sees, and the hidden folders in them, such as the grader and the rubrics.

    :param path: the module search path.
    """
    from .rubrics.catalogue import rubrics_folder  # imported here, because a starter is created before the rest is loaded

    own = os.path.dirname(os.path.abspath(__file__))
    hidden = [os.path.realpath(each) for each in (own, rubrics_folder())]
    engine = os.path.realpath(engine_folder())
    packages = [place for each in path for place in ([each] if _is_of_python(each) else _needed_in(each))]
    return [sys.prefix, sys.base_prefix, engine, *SYSTEM, *packages], hidden


def _is_of_python(path: str) -> bool:
    """Return whether a folder belongs to Python or contains installed packages.

    Any other folder, for example from PYTHONPATH or pytest, may contain private files.
    """
    roots = [os.path.join(os.path.realpath(root), 'lib', '') for root in (sys.prefix, sys.base_prefix)]
    real = os.path.realpath(path)
    return os.path.basename(real) in PACKAGES or any(f'{real}{os.sep}'.startswith(root) for root in roots)


def _needed_in(path: str) -> list[str]:
    """Return the paths in a folder that the engine needs."""
    return [place for place in (os.path.join(path, name) for name in NEEDED) if os.path.exists(place)]


def _beneath(place: str, hidden: Sequence[str], seen: set[str]) -> Iterator[tuple[str, bool]]:
    """Yield (path, whether everything below it is included), so that together they cover `place` without its hidden parts.

    Links are resolved.
    """
    if place in seen or any(place == each or place.startswith(os.path.join(each, '')) for each in hidden):
        return
    seen.add(place)
    if not any(each.startswith(os.path.join(place, '')) for each in hidden):
        yield place, True
        return
    yield place, False
    for name in sorted(os.listdir(place)):
        yield from _beneath(os.path.realpath(os.path.join(place, name)), hidden, seen)
