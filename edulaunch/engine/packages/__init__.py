"""Where packages are: an ament index over install prefixes, source workspaces and the built-in underlay.

Nothing here imports or runs a student's file, and nothing knows a build tool: an `Index` of source workspaces is given a
`SourceReader` for their build files. Read `index.py` first, then the kinds of place that it searches (`prefix.py`,
`workspace.py`), then how a source package is found and what a reader of it returns (`reading.py`).
"""

from __future__ import annotations

from edulaunch.engine.packages.index import Index
from edulaunch.engine.packages.reading import PackageWarning, Program, SourceReader

__all__ = ['Index', 'PackageWarning', 'Program', 'SourceReader']
