"""Paths that hold only in one folder, or on one machine."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.outlines import branches, launch_files, nodes, place_of
from edulaunch.advice.rule import rule

if TYPE_CHECKING:
    from edulaunch.plan import Rehearsal

LESSON = '05_large_project'
DO = (
    'write $(dirname)/{xml}, or $(find-pkg-share my_package)/... for a file of a package',
    "write os.path.join(os.path.dirname(__file__), '{path}'), or the path in the share folder of your package",
)


@rule(
    'launch.relative-path',
    what='{path} is looked for in the folder from which launch is started, not beside the launch file',
    why='it is found as long as everybody starts launch from that one folder',
    do=DO,
    lesson=LESSON,
)
def relative_path(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Of an included launch file, and of a parameter file."""
    for branch in branches(rehearsal):
        if branch.item is not None and branch.item['kind'] == 'include' and branch.origin is not None:
            location = branch.action.launch_description_source.location
            if not os.path.isabs(location) and os.path.isfile(location):
                yield _of_path(location, place_of(branch))
    for branch, item in nodes(rehearsal):
        given = [source['file'] for source in item['parameter_sources']]
        for path in (*given, *branch.action.missing_parameter_files()):
            if not os.path.isabs(path):
                yield _of_path(path, place_of(branch))


def _of_path(path: str, place: dict[str, Any]) -> Finding:
    is_python = str(place.get('file', '')).endswith('.py')
    return found('path', path, **place, xml=None if is_python else path)


_HOME = re.compile(r"""['"](/(?:home|Users)/[\w.-]+/[^'"\n]*)['"]""")


@rule(
    'launch.path-of-one-machine',
    what='the path {path} is written out, and is there on one machine only',
    why='a home folder belongs to one person on one machine',
    do="build it from the package: PathJoinSubstitution([FindPackageShare('my_package'), '{folder}', '{leaf}'])",
    lesson=LESSON,
    level='info',
    confidence='asked',
)
def path_of_one_machine(rehearsal: Rehearsal) -> Iterator[Finding]:
    """A path below a home folder that is written out."""
    from launch._failure import is_students

    from edulaunch.workspace.sources import read_text

    for file in filter(is_students, launch_files(rehearsal)):
        for number, line in enumerate(read_text(file).splitlines(), 1):
            written = _HOME.search(line)
            if written is not None and not line.lstrip().startswith('#'):
                folder, leaf = os.path.split(written[1].rstrip('/'))
                yield found('path', written[1], file=file, line=number, leaf=leaf, folder=os.path.basename(folder))
