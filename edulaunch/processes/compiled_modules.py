"""Modules of the workspace that are compiled code, or would be after a build: they cannot run in the simulation."""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

ENDINGS = ('.so', '.dylib', '.pyd', '.pyx')
"""Compiled for Unix, macOS and Windows, and what Cython would compile."""
_TARGET = r'(?:pybind11_add_module|nanobind_add_module|[Pp]ython3?_add_library|cython_add_module)\s*\(\s*{name}\b'
_LIBRARY = re.compile(r'(\S+): cannot open shared object file')


def compiled_module(process: Process, name: str) -> str | None:
    """Where the compiled code of a module is that Python did not find, 'robo/fast.so', or what would make it; None: nowhere."""
    parent, _, leaf = name.rpartition('.')
    if parent:
        folders = list(getattr(process.loader.modules.get(parent), '__path__', ()))
    else:
        folders = process.loader.finder.folders()
    for folder in folders:
        for file in sorted(os.listdir(folder)) if os.path.isdir(folder) else ():
            if file.endswith(ENDINGS) and file.partition('.')[0] == leaf:
                return f'{os.path.basename(folder)}/{file}'
    return _built_by_cmake(process, name.partition('.')[0], leaf)


def missing_library(error: BaseException) -> str | None:
    """The native library that the operating system did not find when something was loaded."""
    found = _LIBRARY.match(str(error))
    return found[1] if found is not None else None


def _built_by_cmake(process: Process, package: str, leaf: str) -> str | None:
    source = process.index.source_folder(package) if package in process.index.packages() else None
    try:
        with open(os.path.join(source or '', 'CMakeLists.txt'), encoding='utf-8', errors='replace') as file:
            text = file.read()
    except OSError:
        return None
    found = re.search(_TARGET.format(name=re.escape(leaf)), text) if source is not None else None
    return None if found is None else f'{package}/CMakeLists.txt:{text.count(chr(10), 0, found.start()) + 1}'
