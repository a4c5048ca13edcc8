"""Functions that the engine needs from other parts of edulaunch. The top-level package sets them.

A plain script or a notebook cell that imports rclpy runs outside any launched program. When it first uses ROS, it needs its own
machine. Code that requests a picture of a recording needs the package that draws the picture. The engine creates neither.
`import edulaunch` loads this small module, but not the packages that use it.
"""

from __future__ import annotations

TYPE_CHECKING = False  # equals `typing.TYPE_CHECKING`, but does not load `typing`
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


def _nobody(task: Any) -> Any:
    raise RuntimeError('no machine for code outside a launched program: import edulaunch first')


def _load_nothing(name: str) -> object:
    raise RuntimeError(f'nothing shows {name!r} of a recording: import edulaunch first')


make_process: Callable[[Any], Any] = _nobody
"""Called with the ambient task of a thread; returns the process for the code of the thread."""
load_view: Callable[[str], object] = _load_nothing
"""Called with the name of a view of recordings that is not registered yet: imports the wing that registers it."""
