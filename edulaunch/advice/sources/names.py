"""The name of a package, which stands in several files and must be the same in all."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule
from edulaunch.workspace.sources import read_text

if TYPE_CHECKING:
    from edulaunch.advice.source_package import Source

_SETUP_NAME = re.compile(r"""^\s*(?:package_name|name)\s*=\s*['"]([\w.-]+)['"]""", re.MULTILINE)
_PROJECT = re.compile(r'^\s*project\s*\(\s*([\w.-]+)', re.MULTILINE | re.IGNORECASE)


@rule(
    'packages.name-differs',
    what="package.xml calls the package '{package}', {written} calls it '{other}'",
    why='what is built under one name is looked for under the other',
    do="write '{package}' in both",
    lesson='05_large_project',
    level='error',
)
def name_differs(source: Source) -> Iterator[Finding]:
    """By `package_name =` or `name=` in setup.py, or project() in CMakeLists.txt."""
    package = source.package
    build = package.build_file()
    pattern = _SETUP_NAME if package.is_python else _PROJECT
    named = pattern.search(read_text(build))
    if named is not None and named[1] not in (package.name, package.name.replace('_', '-')):
        line = read_text(build).count('\n', 0, named.start(1)) + 1
        yield found('package', package.name, file=build, line=line, other=named[1], written=os.path.basename(build))
