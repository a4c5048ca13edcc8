"""Where packages are: an ament index over install prefixes, source workspaces and the built-in underlay.

Nothing here imports or runs a student's file: setup.py and CMakeLists.txt are read as text. Read `index.py`
first, then the three kinds of place it searches (`prefix.py`, `underlay.py`, `workspace.py`), then how a
source package is read (`setup_script.py`, `cmake.py`) and presented as if installed (`image.py`).
"""

from __future__ import annotations

from edulaunch.packages.index import Index
from edulaunch.packages.program import Program
from edulaunch.packages.reading import PackageWarning

__all__ = ['Index', 'PackageWarning', 'Program']
