"""Packages and modules that a robot's machine may have and edulaunch lacks.

A student's ROS machine has such packages, so a launch that names them continues there. Such a launch also continues here,
and the programs of these packages end immediately with an explanation. The modules are never found, even if they are
installed on the real machine, and the error names the missing software. The names are in a data file beside the built-in
packages.
"""

from __future__ import annotations

from edulaunch.engine.underlay_place import underlay_data

_TABLE = underlay_data('absent.json')

KINDS: dict[str, dict[str, list[str]]] = _TABLE['kinds']
"""For each kind of software, the names of its `packages` (`*` matches any text) and its Python `modules`."""
REFUSED: frozenset[str] = frozenset(_TABLE['refused'])
"""Modules that would open windows on the real screen, use the real keyboard or not see the student's packages. So they are not
found even where they are installed. `tkinter` has a view.
"""


def absent_kind(package: str) -> str | None:
    """Return the software that an absent package belongs to.

    Return None for an unknown name, which would be an error in ROS 2, too.
    """
    from fnmatch import fnmatchcase  # imported here, because most launches do not need it

    return next(
        (kind for kind, names in KINDS.items() if any(fnmatchcase(package, name) for name in names.get('packages', ()))), None
    )


def absent_module_kind(module: str) -> str | None:
    """Return the software that a missing module belongs to, or None for an unknown name."""
    return next((kind for kind, names in KINDS.items() if module in names.get('modules', ())), None)
