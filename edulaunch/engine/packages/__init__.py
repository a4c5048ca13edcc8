"""Finds packages: an ament index over install prefixes, source workspaces and the built-in underlay. This package neither imports
nor runs a student's file, and it knows no build tool. An `Index` of source workspaces uses a `SourceReader` for their build
files. First read `index.py`, then the kinds of place that it searches (`prefix.py`, `workspace.py`). `reading.py` finds a source
package, and defines what a reader of it returns.
"""

from __future__ import annotations

from edulaunch.engine.packages.index import Index
from edulaunch.engine.packages.reading import PackageWarning, Program, SourceReader

__all__ = ['Index', 'PackageWarning', 'Program', 'SourceReader']
