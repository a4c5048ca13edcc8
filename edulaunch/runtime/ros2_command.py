"""The seam for the `ros2` command of a simulated machine: the wing `desk`, above this one, has it; the facade sets it here."""

from __future__ import annotations

TYPE_CHECKING = False  # as `typing.TYPE_CHECKING`, without loading `typing`: every `import edulaunch` loads this module
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any


def _nobody(*arguments: Any) -> Any:
    raise RuntimeError('no ros2 command: import edulaunch first')


run: Callable[[Any], Any] = _nobody
"""Called with the process of a `ros2` command line; returns its exit code."""
complete: Callable[[list[str], str, Callable[[], Any], Callable[[str], list[str]]], Iterable[str]] = _nobody
"""Called with the words behind `ros2`, what is typed of the next one, a function that gives the index of packages, and one that
gives the lines which a command prints; returns what the next word may be.
"""
