"""Finding ROS packages for the `conftest.py` files of a pytest run; runs that need none of them notice nothing."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec
from importlib.util import find_spec
from pathlib import Path
from types import FrameType, ModuleType

import pytest

from edulaunch.testing.package_tests import is_of_own_package
from edulaunch.underlay_place import underlay_python

SOURCED_LATE = pytest.StashKey[bool]()
"""Of a run of pytest: that the underlay was sourced here, not by the user himself."""


class LateSource:
    """The last finder that Python asks. When a `conftest.py` imports a ROS package that nobody has, it sources the underlay.

    One inside a package of the user goes on the machine of the tests, so it finds that package and its interfaces, too.
    """

    def __init__(self, config: pytest.Config) -> None:
        self._config = config
        self._done: set[str] = set()

    def install(self) -> None:
        """Begin to be asked."""
        sys.meta_path.append(self)

    def find_spec(self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> ModuleSpec | None:
        """Where the module is, if it is ours to find."""
        conftest = _importing_conftest(sys._getframe(1))
        if conftest is None or conftest in self._done:
            return None
        if is_of_own_package(conftest):
            from edulaunch.testing.machine_plugin import put_on_machine

            put_on_machine(self._config, Path(conftest))
        elif _is_ros_name(name):
            from edulaunch.sourcing import source

            source()
            self._config.stash[SOURCED_LATE] = True
        else:
            return None
        self._done.add(conftest)
        return find_spec(name)


def _is_ros_name(name: str) -> bool:
    return name.endswith('_msgs') or ('.' not in name and os.path.isdir(os.path.join(underlay_python(), name)))


def _importing_conftest(frame: FrameType | None) -> str | None:
    """The conftest.py in which the import statement stands that is being executed."""
    while frame is not None and 'importlib' in frame.f_code.co_filename:
        frame = frame.f_back
    file = '' if frame is None else frame.f_code.co_filename
    return file if os.path.basename(file) == 'conftest.py' else None
