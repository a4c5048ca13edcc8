"""Finding ROS packages for the `conftest.py` files of a pytest run; runs that need none of them notice nothing."""
from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec
from importlib.util import find_spec
from types import FrameType, ModuleType

from edulaunch.underlay_place import underlay_python


class LateSource:
    """The last finder that Python asks. When a `conftest.py` imports a ROS package that nobody has, it sources the underlay."""

    def install(self) -> None:
        """Begin to be asked."""
        sys.meta_path.append(self)

    def find_spec(self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> ModuleSpec | None:
        """Where the module is, if it is ours to find."""
        if not _is_ros_name(name) or not _is_conftest(sys._getframe(1)):
            return None
        sys.meta_path.remove(self)
        from edulaunch.sourcing import source
        source()
        return find_spec(name)


def _is_ros_name(name: str) -> bool:
    return name.endswith('_msgs') or ('.' not in name and os.path.isdir(os.path.join(underlay_python(), name)))


def _is_conftest(frame: FrameType | None) -> bool:
    """Whether the import statement that is being executed stands in a conftest.py."""
    while frame is not None and 'importlib' in frame.f_code.co_filename:
        frame = frame.f_back
    return frame is not None and os.path.basename(frame.f_code.co_filename) == 'conftest.py'
