"""The seam for code that runs outside any launched program, such as a plain script or a notebook cell that imports rclpy.

Such code needs a machine of its own at its first use of ROS. The engine makes none: what is set here makes it.
"""

from __future__ import annotations

TYPE_CHECKING = False  # as `typing.TYPE_CHECKING`, without loading `typing`
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


def _nobody(task: Any) -> Any:
    raise RuntimeError('no machine for code outside a launched program: import edulaunch first')


make_process: Callable[[Any], Any] = _nobody
"""Called with the ambient task of a thread; gives the process that stands for its code."""
