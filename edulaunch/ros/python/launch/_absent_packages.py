"""How launch handles a missing well-known package of ROS 2: it reports the missing package and continues without it."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

from ._engine import absent_package, running_process


def is_left_out(path: str) -> bool:
    """Return whether an included launch file belongs to a missing well-known package. If so, log an error."""
    known = absent_file(path)
    if known:
        sentence = f'the package {known["package"]!r} ({known["belongs_to"]}) is not here'
        _tell(f'{path[len(_share()) :]} is not included: {sentence}; the rest of the launch continues without it')
    return bool(known)


def absent_file(path: str) -> dict[str, Any]:
    """Return the facts about a missing file of a missing well-known package. Return an empty dictionary for any other file."""
    share = _share()
    package = path[len(share) :].partition(os.sep)[0] if path.startswith(share) else ''
    kind = absent_package(package)
    return {} if kind is None else {'about': 'packages.absent-file', 'package': package, 'belongs_to': kind}


def _share() -> str:
    """Return the folder that would contain the share folders of missing well-known packages, with a separator at its end."""
    return os.path.join(running_process().index.absent_prefix, 'share', '')


def absent_program(name: str) -> str | None:
    """Return the path that a program of a missing well-known package would have. Return None for any other name."""
    prefix = running_process().index.absent_prefix
    return os.path.join(prefix, 'lib', name, name) if absent_package(name) is not None else None


def is_empty_output(argv: Sequence[str]) -> bool:
    """Return whether the program of a command belongs to a missing well-known package, so that the output of the command is
    empty.

    If so, log an error.
    """
    name = os.path.basename(argv[0]) if argv else ''
    from osrf_pycommon.process_utils import which

    path = absent_program(name)
    if path is None or argv[0] != path and (argv[0] != name or which(name) is not None):
        return False
    _tell(f'the program {name!r} ({absent_package(name)}) is not here: the output of its command is empty')
    return True


def _tell(sentence: str) -> None:
    from .logging import get_logger

    get_logger('launch').error(sentence)
