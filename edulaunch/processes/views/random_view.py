"""`random`, seeded per process: a student's unseeded randomness repeats from run to run."""

from __future__ import annotations

import random as real
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names
from edulaunch.sim.task import current_task

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

NAMES = [name for name in dir(real.Random) if not name.startswith('_') and hasattr(real, name)]


class Random(real.Random):
    """As `random.Random`; without a seed it is seeded from the process's generator, not from the machine."""

    def __init__(self, x: Any = None) -> None:
        super().__init__(_generator_here().random() if x is None else x)

    def seed(self, a: Any = None, version: int = 2) -> None:
        """As `random.Random.seed`, never from the machine."""
        super().seed(_generator_here().random() if a is None else a, version)


def _generator_here() -> real.Random:
    generator: real.Random = current_task().owner.state['random']
    return generator


def make(view: ModuleType, process: Process) -> ModuleType:
    """Module functions use one generator seeded by (simulation seed, process name); `Random()` draws its seed from it."""
    generator = process.state['random'] = process.sim.random(process.name)
    for name in NAMES:
        view.__dict__[name] = getattr(generator, name)
    view.__dict__['seed'] = lambda a=None, version=2: generator.seed(
        f'{process.sim.seed}/{process.name}' if a is None else a, version
    )
    view.__dict__['Random'] = view.__dict__['SystemRandom'] = Random
    copy_names(view, real)
    return view
