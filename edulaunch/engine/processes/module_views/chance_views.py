"""`random`, `uuid` and `numpy.random` with a seed for each process: unseeded random numbers of a student are the same in each
run.
"""

from __future__ import annotations

import random
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.module_views import copy_names
from edulaunch.engine.sim.task import current_task

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process

DRAWING = [name for name in dir(random.Random) if not name.startswith('_') and hasattr(random, name)]


class Random(random.Random):
    """The simulated `random.Random`. Without a seed, the seed comes from the process's generator instead of the real machine."""

    def __init__(self, x: Any = None) -> None:
        super().__init__(_generator_here().random() if x is None else x)

    def seed(self, a: Any = None, version: int = 2) -> None:
        """Set the seed like `random.Random.seed`. Without a seed, use the process's generator instead of the real machine."""
        super().seed(_generator_here().random() if a is None else a, version)


def _generator_here() -> random.Random:
    generator: random.Random = current_task().owner.state['random']
    return generator


def make_random(view: ModuleType, process: Process) -> ModuleType:
    """Make the module's functions use one generator, seeded with (simulation seed, process name), and return the module.

    An unseeded `Random()` gets its seed from this generator, too.
    """
    generator = process.state['random'] = process.sim.random(process.name)
    for name in DRAWING:
        view.__dict__[name] = getattr(generator, name)
    view.__dict__['seed'] = lambda a=None, version=2: generator.seed(
        f'{process.sim.seed}/{process.name}' if a is None else a, version
    )
    view.__dict__['Random'] = view.__dict__['SystemRandom'] = Random
    copy_names(view, random)
    return view


def make_uuid(view: ModuleType, process: Process) -> ModuleType:
    """Make `uuid1` and `uuid4` use a generator that is seeded with (simulation seed, process name), and return the module."""
    import uuid

    generator = process.sim.random(f'{process.name}/uuid')

    def uuid4() -> uuid.UUID:
        return uuid.UUID(int=generator.getrandbits(128), version=4)

    def uuid1(node: int | None = None, clock_seq: int | None = None) -> uuid.UUID:
        return uuid.UUID(int=generator.getrandbits(128), version=1)

    view.__dict__.update(uuid1=uuid1, uuid4=uuid4, getnode=lambda: 0x0242AC110002)
    copy_names(view, uuid)
    return view


class NumpyView(ModuleType):
    """A view of `numpy`. Everything except `random` comes from the real numpy, and modules that numpy loads late are loaded on
    first use.
    """

    def __init__(self) -> None:
        super().__init__('numpy')
        self.__edulaunch_view__ = True

    def __getattr__(self, name: str) -> Any:
        import numpy

        return getattr(numpy, name)


def make_numpy(view: ModuleType, process: Process) -> ModuleType:
    """Return a :class:`NumpyView` of the module."""
    import numpy

    made = NumpyView()
    made.__dict__['random'] = process.loader.import_module('numpy.random')
    copy_names(made, numpy)
    return made


def make_numpy_random(view: ModuleType, process: Process) -> ModuleType:
    """Make the module's functions use one generator, seeded with (simulation seed, process name), and return the module.

    Unseeded generators get their seed from the same source.
    """
    import numpy

    source = process.sim.random(f'{process.name}/numpy')
    state = numpy.random.RandomState(source.getrandbits(32))

    def default_rng(seed: Any = None) -> Any:
        return numpy.random.default_rng(source.getrandbits(128) if seed is None else seed)

    def seed(seed: Any = None) -> None:
        state.seed(source.getrandbits(32) if seed is None else seed)

    class RandomState(numpy.random.RandomState):
        """The simulated `numpy.random.RandomState`. Without a seed, the seed comes from the process's generator."""

        def __init__(self, seed: Any = None) -> None:
            super().__init__(source.getrandbits(32) if seed is None else seed)

    for name in dir(state):
        if not name.startswith('_') and hasattr(numpy.random, name):
            view.__dict__[name] = getattr(state, name)
    view.__dict__.update(default_rng=default_rng, seed=seed, RandomState=RandomState)
    copy_names(view, numpy.random)
    return view
