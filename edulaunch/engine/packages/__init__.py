"""Where packages are: an ament index over install prefixes, source workspaces and the built-in underlay.

Nothing here imports or runs a student's file: setup.py and CMakeLists.txt are read as text. Read `index.py`
first, then the kinds of place it searches (`prefix.py`, `workspace.py`), then how a source package is found and read
(`reading.py`, `setup_script.py`, `cmake.py`).
"""

from __future__ import annotations

from edulaunch.engine.packages.index import Index
from edulaunch.engine.packages.reading import PackageWarning, Program

__all__ = ['Index', 'PackageWarning', 'Program']
