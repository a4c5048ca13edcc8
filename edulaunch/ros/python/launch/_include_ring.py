"""Detects launch files that include themselves without end."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.engine.facts import with_facts

if TYPE_CHECKING:
    from edulaunch.engine.processes import Origin

DEEPEST = 50
"""How many times a file may include itself with different launch configurations."""


class Include(NamedTuple):
    """A launch file that is being visited.

    :ivar file: the path of the launch file.
    :ivar origin: the place of the action that includes the file; None if it is unknown.
    :ivar configurations: the launch configurations before the arguments of the include were set.
    """

    file: str
    origin: Origin | None
    configurations: dict[str, Any]


def enter_include(open_includes: list[Include] | None, entered: Include) -> None:
    """Add a file to the files that are being visited.

    A file may include itself if the recursion ends, for example through a condition on an argument that counts down.

    :param open_includes: the files that are being visited, the outermost first. None outside of a walk, where the end of a visit
        is unknown. The call then has no effect.
    :raises RecursionError: when the file would include itself without end, because no launch configuration has changed since its
        last include, or because the depth exceeds the limit. The message names the files of the cycle.
    """
    if open_includes is None:
        return
    before = [number for number, include in enumerate(open_includes) if include.file == entered.file]
    if before and (len(before) >= DEEPEST or open_includes[before[-1]].configurations == entered.configurations):
        raise _ring_error([*open_includes[before[-1] :], entered])
    open_includes.append(entered)


def _ring_error(ring: list[Include]) -> RecursionError:
    steps = [f'{_shown(include)} includes {os.path.basename(inner.file)}' for include, inner in zip(ring, ring[1:], strict=False)]
    error = RecursionError(
        f"launch file '{ring[0].file}' includes itself without end: "
        + ', '.join(
            f'{step} (line {inner.origin.line})' if inner.origin is not None else step
            for step, inner in zip(steps, ring[1:], strict=True)
        )
    )
    names = [_shown(include) for include in ring]
    itself = names[0] if len(set(names)) == 1 else None
    return with_facts(error, 'launch.include-ring', ring=names, itself=itself)


def _shown(include: Include) -> str:
    return os.path.basename(include.file)
