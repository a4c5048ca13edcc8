"""What was built of a package and is older than its sources."""

from __future__ import annotations

import glob
import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule

if TYPE_CHECKING:
    from edulaunch.advice.source_package import Source

LEVELS_ABOVE = 4
"""So far above a package its workspace is looked for."""


@rule(
    'packages.changed-after-build',
    what='{package} was changed after it was built: {changed}',
    why='a real ROS 2 runs what colcon has installed; edulaunch runs the sources, so here you see the change already',
    do='build it again in {workspace}: colcon build --packages-select {package}, or once with --symlink-install',
    level='info',
    lesson='05_large_project',
)
def changed_after_build(source: Source) -> Iterator[Finding]:
    """By content, not by time: files of the source that are other than what is installed, or are not installed at all."""
    package = source.package
    prefix, workspace = _installed_prefix(package.folder, package.name)
    if prefix is None or not source.is_readable:
        return
    files = package.contents.files.items()
    pairs = {os.path.join(prefix, name): path for name, path in files if not name.startswith('share/ament_index/')}
    for place in glob.glob(os.path.join(glob.escape(prefix), 'lib', 'python3*', 'site-packages')):
        for top, folder in package.contents.python_modules.items():
            inside = [path for path in package.python_files if path.startswith(folder + os.sep)]
            pairs.update({os.path.join(place, top, os.path.relpath(path, folder)): path for path in inside})
    changed = [package.relative(path) for built, path in pairs.items() if not _is_equal(built, path)]
    if changed:
        first = os.path.join(package.folder, changed[0])
        yield found('package', package.name, file=first, changed=changed[:3], workspace=os.path.basename(workspace))


def _installed_prefix(folder: str, package: str) -> tuple[str | None, str]:
    """The prefix in which colcon has installed a package, alone or with all others, and the workspace."""
    for _ in range(LEVELS_ABOVE):
        folder = os.path.dirname(folder)
        for prefix in (os.path.join(folder, 'install', package), os.path.join(folder, 'install')):
            if os.path.isfile(os.path.join(prefix, 'share', package, 'package.xml')):
                return prefix, folder
    return None, folder


def _is_equal(built: str, path: str) -> bool:
    """Whether the installed file is the one of the sources, or has the same content."""
    if not os.path.isfile(path) or os.path.realpath(built) == os.path.realpath(path):
        return True
    try:
        with open(built, 'rb') as one, open(path, 'rb') as other:
            return one.read() == other.read()
    except OSError:
        return False
