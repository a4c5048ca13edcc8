"""The `conftest.py` files of packages under test, which pytest imports before any test file."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec
from importlib.util import find_spec
from pathlib import Path
from types import FrameType, ModuleType

import pytest

from edulaunch.testing.machine_plugin import put_on_machine
from edulaunch.testing.package_tests import is_of_own_package


class ConftestImports:
    """The first finder that Python asks: puts a `conftest.py` inside a package of the user on the machine of the tests.

    So it finds that package and its interfaces too. What it imports before anything is looked for stays as it is.
    """

    def __init__(self, config: pytest.Config) -> None:
        self._config = config
        self._seen: set[str] = set()

    def install(self) -> None:
        """Be asked until the end of the run."""
        sys.meta_path.insert(0, self)
        self._config.add_cleanup(lambda: sys.meta_path.remove(self))

    def find_spec(self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> ModuleSpec | None:
        """Where the module is, if the machine of the tests knows it and this import is the first of a conftest.py."""
        conftest = _importing_conftest(sys._getframe(1))
        if conftest is None or conftest in self._seen:
            return None
        self._seen.add(conftest)
        if not is_of_own_package(conftest):
            return None
        put_on_machine(self._config, Path(conftest))
        return find_spec(name)


def _importing_conftest(frame: FrameType | None) -> str | None:
    """The conftest.py in which the import statement stands that is being executed."""
    while frame is not None and 'importlib' in frame.f_code.co_filename:
        frame = frame.f_back
    file = '' if frame is None else frame.f_code.co_filename
    return file if os.path.basename(file) == 'conftest.py' else None
