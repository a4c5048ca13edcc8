"""Queries about a dry run that several rules need: its nodes, its launch files, and its places."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.advice.plan import Rehearsal
    from edulaunch.advice.plan.titles import Branch


def branches(rehearsal: Rehearsal) -> Iterator[Branch]:
    """Yield all branches that launch visited, in order."""
    from edulaunch.advice.plan.why import branches

    return branches(rehearsal.outline)


def nodes(rehearsal: Rehearsal) -> Iterator[tuple[Branch, dict[str, Any]]]:
    """Yield each executed node action as (branch, item)."""
    for branch in branches(rehearsal):
        if branch.item is not None and branch.item['kind'] == 'node':
            yield branch, branch.item


def name_of(item: dict[str, Any]) -> str:
    """Return the name of a planned node, or its executable if the launch file gives the node no name."""
    name: str = item['runtime_name'] or item['executable']
    return name


def place_of(branch: Branch) -> dict[str, Any]:
    """Return `file` and `line` for a finding about a branch.

    The file is the student's own file, not the link in the installed package.
    """
    return {} if branch.origin is None else {'file': os.path.realpath(branch.origin.file), 'line': branch.origin.line}


def launch_files(rehearsal: Rehearsal) -> list[str]:
    """Return the paths of the launch files that launch has read, in order."""
    files = [rehearsal.plan['file'], *(item['file'] for item in rehearsal.plan['items'] if item['kind'] == 'include')]
    return [file for file in dict.fromkeys(map(os.path.realpath, files)) if os.path.isfile(file)]


def students_python(rehearsal: Rehearsal) -> Iterator[tuple[str, ast.Module]]:
    """Yield the student's own Python launch files with their syntax trees. No code of the files is executed."""
    from edulaunch.engine.underlay_place import is_students
    from edulaunch.ros.sources.source_package import parsed

    for file in launch_files(rehearsal):
        tree = parsed(file) if file.endswith('.py') and is_students(file) else None
        if tree is not None:
            yield file, tree
