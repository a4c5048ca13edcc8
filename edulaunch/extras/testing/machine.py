"""The simulated machine for the launch_pytest tests of a pytest run.

pytest itself is a plain script on this machine. Fixtures, tests and launches share one ROS graph and one simulated time, as they
share the machine in ROS 2. The first such test file opens the machine, so that other runs of pytest do not change. Indirect
imports of the packages' modules (`unittest.mock.patch('my_package.node.x')`, conftest files) return the same modules.
"""

from __future__ import annotations

import builtins
import sys
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from importlib.abc import Loader as ImportLoader
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType
from typing import Any

from greenlet import getcurrent

from edulaunch.engine.packages import Index
from edulaunch.engine.processes.loader import Loader
from edulaunch.engine.processes.module_views import PRIVATE_COPIES
from edulaunch.engine.sim.task import AmbientTask
from edulaunch.errors import SimulationError
from edulaunch.extras.testing import workspaces_of
from edulaunch.runtime.ambient import ambient_process_on
from edulaunch.runtime.session import Session, index_for

SHARED = frozenset(PRIVATE_COPIES) - {'concurrent', 'sched'}
"""The standard modules that a test file, unlike a program, shares with pytest. For example, `caplog` needs the same `logging`."""
LIMIT_S = 900
"""The maximum duration of a test in simulated seconds. It is longer than the 600 s after which a launch test ends."""


class TestImports(ImportLoader):
    """The first module finder of Python. It returns the same modules as imports in the test files."""

    __test__ = False  # so that pytest does not collect this class

    def __init__(self, loader: Loader) -> None:
        self._loader = loader
        self._names: set[str] = set()
        self._given: dict[str, ModuleSpec | None] = {}

    def install(self) -> None:
        """Install the finder."""
        sys.meta_path.insert(0, self)

    def remove(self) -> None:
        """Remove the finder."""
        sys.meta_path.remove(self)
        for name in self._given:
            sys.modules.pop(name, None)

    def find_spec(self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> ModuleSpec | None:
        """Return the spec of a module that belongs to a package under test, or None for any other module."""
        return ModuleSpec(name, self) if name.partition('.')[0] in self._names else None

    def look_again(self) -> None:
        """Update the list of packages that the program can use."""
        overlay = self._loader.process.overlay
        self._names = {*overlay.interface_packages, *overlay.modules} - sys.stdlib_module_names

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """Return the module that the test files import, and execute it if necessary."""
        module = self._loader.import_module(spec.name)
        self._given[spec.name] = module.__spec__
        return module

    def exec_module(self, module: ModuleType) -> None:
        """Restore the original spec of the module, which has already been executed."""
        module.__spec__ = self._given[module.__name__]


class TestMachine:
    """A machine whose ambient process is pytest.

    :param seed: the seed of all random numbers.
    :param workspaces: folders with packages; None means the workspace of each test file.
    """

    __test__ = False  # so that pytest does not collect this class

    def __init__(self, seed: int = 0, workspaces: Sequence[str] | None = None) -> None:
        self.session = Session(seed=seed)
        self.session.recorder.stop()
        self._workspaces = workspaces
        self._task = AmbientTask(self.session.sim)
        self.process = self._task.owner = ambient_process_on(self.session.host, self._task)
        self._files: set[str] = set()
        self._folders: dict[Path, tuple[str, ...]] = {}
        self._indexes: dict[tuple[str, ...], Index] = {}
        self._imports = TestImports(self.process.loader)
        self._outer: Any = None
        self._import: Any = None

    def open(self) -> None:
        """Make this the machine of the current code, until :meth:`close`."""
        here = getcurrent()
        self._outer, here.task = getattr(here, 'task', None), self._task
        self._import, builtins.__import__ = builtins.__import__, self._import_for_tests
        self._imports.install()
        watchdog = self.session.host.watchdog
        if watchdog is not None:
            watchdog.thread = threading.get_ident()

    def close(self) -> None:
        """End all running programs, and restore the previous state."""
        builtins.__import__ = self._import
        self._imports.remove()
        self.session.close()
        getcurrent().task = self._outer or AmbientTask(type(self.session.sim)())

    def add(self, path: Path) -> None:
        """Prepare the import of a test file, whose clocks, threads and commands are then simulated."""
        self._files.add(str(path))

    def enter(self, path: Path) -> None:
        """Prepare to run code of a test file. The code can use the packages around the file."""
        folders = self._folders.get(path.parent)
        if folders is None:
            folders = tuple(workspaces_of(str(path)) if self._workspaces is None else self._workspaces)
            self._folders[path.parent] = folders
        if folders not in self._indexes:
            self._indexes[folders] = index_for(folders)
        index = self._indexes[folders]
        if self.process.index is index:
            return
        self.process.index = self.session.host.index = index
        roots = self.process.loader.roots
        roots += [root for root in index.python_roots() if root not in roots]
        self._imports.look_again()

    @contextmanager
    def limited(self) -> Iterator[None]:
        """Limit a test. A wait of more than `LIMIT_S` simulated seconds fails at the place of the wait."""
        sim = self.session.sim

        def give_up() -> None:
            raise SimulationError(
                f'this test has waited for {LIMIT_S} s of simulated time without success',
                help='give the wait a timeout (timeout_sec=5.0), and assert on its result',
            )

        end = sim.schedule(sim.now_ns + LIMIT_S * 10**9, lambda: self._task.interrupt(give_up))
        try:
            yield
        finally:
            sim.cancel(end)

    def let_debug(self, person_is_here: bool) -> None:
        """Allow a program to run for any time without yielding, while a person uses a debugger."""
        if self.session.host.watchdog is not None:
            self.session.host.watchdog.asleep = person_is_here

    def _import_for_tests(
        self,
        name: str,
        globals: Mapping[str, Any] | None = None,
        locals: Mapping[str, Any] | None = None,
        fromlist: Sequence[str] | None = (),
        level: int = 0,
    ) -> ModuleType:
        """Handle `import` statements. Test files get the same modules as a simulated program."""
        here = None if globals is None else globals.get('__file__')
        if here is None or here not in self._files or name.partition('.')[0] in SHARED:
            module: ModuleType = self._import(name, globals, locals, fromlist, level)
            return module
        return self.process.loader.import_(name, globals, locals, fromlist, level)
