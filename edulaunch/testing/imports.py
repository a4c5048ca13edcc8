"""Modules of the packages under test, for whoever imports them past the test files: `unittest.mock.patch('my_package.node.x')`,
`monkeypatch.setattr`, conftest files and modules beside the tests.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib.abc import Loader as ImportLoader
from importlib.machinery import ModuleSpec
from types import ModuleType

from edulaunch.processes.loader import Loader


class TestImports(ImportLoader):
    """The first finder that Python asks: gives the one module that the test files have, too."""

    __test__ = False  # pytest is not to take this class for a test case

    def __init__(self, loader: Loader) -> None:
        self._loader = loader
        self._names: set[str] = set()
        self._given: dict[str, ModuleSpec | None] = {}

    def install(self) -> None:
        """Begin to be asked."""
        sys.meta_path.insert(0, self)

    def remove(self) -> None:
        """Leave things as they were."""
        sys.meta_path.remove(self)
        for name in self._given:
            sys.modules.pop(name, None)

    def find_spec(self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> ModuleSpec | None:
        """Where the module is, if it is of a package under test."""
        return ModuleSpec(name, self) if name.partition('.')[0] in self._names else None

    def look_again(self) -> None:
        """The program sees other packages now."""
        overlay = self._loader.process.overlay
        self._names = {*overlay.interface_packages, *overlay.modules} - sys.stdlib_module_names

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """The module of the test files; it is executed when it is not there yet."""
        module = self._loader.import_module(spec.name)
        self._given[spec.name] = module.__spec__
        return module

    def exec_module(self, module: ModuleType) -> None:
        """It has been executed; it keeps the description that it had."""
        module.__spec__ = self._given[module.__name__]
