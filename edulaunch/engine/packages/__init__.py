"""Finds packages: an ament index over install prefixes, source workspaces and the built-in underlay.

This package neither imports nor runs a student's file, and it does not depend on a build tool. An `Index` of source
workspaces gets a `SourceReader`, which reads their build files. First read `index.py`, then the kinds of place that it
searches (`prefix.py`, `workspace.py`). `reading.py` finds source packages, and defines what a `SourceReader` returns.
"""

from __future__ import annotations

from edulaunch.engine.packages.index import Index
from edulaunch.engine.packages.reading import PackageWarning, Program, SourceReader

__all__ = ['Index', 'PackageWarning', 'Program', 'SourceReader']
