"""Check setup.py and package.xml in an editor: apply the rules for sources to a copy of the package with the new content."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from tempfile import TemporaryDirectory

from edulaunch.advice.judging import judge_sources
from edulaunch.advice.rule import Finding
from edulaunch.advice.texts.text import Text
from edulaunch.engine.packages.discovery import package_around

MOST_FILES = 300
LEFT_OUT = frozenset(('.git', '__pycache__', 'build', 'install', 'log', 'node_modules'))


def findings_of_package(text: Text) -> list[Finding]:
    """Return the findings about a file, for a package that contains the new content instead of the stored file."""
    folder = package_around(os.path.dirname(text.path))
    if folder is None:
        return []
    with TemporaryDirectory(prefix='edulaunch-check-') as room:
        copy = os.path.join(room, os.path.basename(folder))
        _link(folder, copy)
        place = os.path.join(copy, os.path.relpath(text.path, folder))
        if os.path.lexists(place):
            os.remove(place)
        with open(place, 'w', encoding='utf-8') as file:
            file.write(text.text)
        return [finding._replace(file=text.path) for finding in judge_sources(copy) if finding.file == place]


def _link(folder: str, copy: str) -> None:
    """Create a copy of a folder that contains links to the same files. The files that define the package are copied."""
    for number, path in enumerate(_files(folder)):
        if number >= MOST_FILES:
            return
        place = os.path.join(copy, os.path.relpath(path, folder))
        os.makedirs(os.path.dirname(place), exist_ok=True)
        if os.path.basename(path) in ('package.xml', 'setup.py', 'setup.cfg', 'CMakeLists.txt'):
            shutil.copyfile(path, place)
        else:
            os.symlink(path, place)


def _files(folder: str) -> Iterator[str]:
    for place, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name not in LEFT_OUT and not name.startswith('.'))
        yield from (os.path.join(place, name) for name in sorted(names))
