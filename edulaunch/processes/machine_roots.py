"""The folders of this machine whose places a digest must not depend on."""

from __future__ import annotations

import os
import site
import sys
import sysconfig
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import suppress

SYSTEM = frozenset({'', '/', '/usr', '/usr/local', '/home', '/opt'})
"""Folders that are no place of their own: other things lie in them on every machine."""


def machine_roots() -> list[list[str]]:
    """(folder, short name), those that say more first: where two are the same folder the first one counts."""
    packages = [sysconfig.get_path('purelib'), sysconfig.get_path('platlib'), site.getusersitepackages()]
    found = [
        (sys.executable, '@sys.executable'),
        (tempfile.gettempdir(), '@tmp'),
        (os.path.dirname(os.__file__), '@stdlib'),
        *((folder, '@site-packages') for folder in packages if folder),  # a browser has no folder of the user
        (sys.prefix, '@sys.prefix'),
        (sys.base_prefix, '@sys.base_prefix'),
    ]
    with suppress(FileNotFoundError):  # the folder was removed meanwhile
        found.append((os.getcwd(), '@cwd'))
    return [*with_real_paths(found), *with_real_paths([(os.path.expanduser('~'), '@home')])]


def with_real_paths(roots: Iterable[tuple[str, str]]) -> Iterator[list[str]]:
    """The roots, each followed by what it is when links are followed; without the folders of the system."""
    for path, name in roots:
        for place in dict.fromkeys((path, os.path.realpath(path))):
            if place not in SYSTEM:
                yield [place, name]
