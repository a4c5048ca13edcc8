"""The connection to the `ros2` command of a simulated machine. `edulaunch.desk` contains the command, and the facade sets it
here.
"""

from __future__ import annotations

TYPE_CHECKING = False  # equals `typing.TYPE_CHECKING`, but does not load `typing`: every `import edulaunch` loads this module
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Any


def _nobody(*arguments: Any) -> Any:
    raise RuntimeError('no ros2 command: import edulaunch first')


run: Callable[[Any], Any] = _nobody
"""Called with the process of a `ros2` command line; returns its exit code."""
complete: Callable[[list[str], str, Callable[[], Any], Callable[[str], list[str]]], Iterable[str]] = _nobody
"""Called with the words after `ros2`, the typed part of the next word, and two functions. The first one returns the index of
packages, and the second one the lines which a command prints. Returns the candidates for the next word.
"""
