"""numpy with a `random` of the program's own: a student's unseeded randomness repeats from run to run."""

from __future__ import annotations

from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


class NumpyView(ModuleType):
    """Everything but `random` is the real numpy's; parts that numpy loads late come when they are asked for."""

    def __init__(self) -> None:
        super().__init__('numpy')
        self.__edulaunch_view__ = True

    def __getattr__(self, name: str) -> Any:
        import numpy

        return getattr(numpy, name)


def make(view: ModuleType, process: Process) -> ModuleType:
    """See `NumpyView`."""
    import numpy

    made = NumpyView()
    made.__dict__['random'] = process.loader.import_module('numpy.random')
    copy_names(made, numpy)
    return made


def make_random(view: ModuleType, process: Process) -> ModuleType:
    """The module's functions draw from one generator, seeded by (simulation seed, process name), as do generators that are made
    without a seed.
    """
    import numpy

    source = process.sim.random(f'{process.name}/numpy')
    state = numpy.random.RandomState(source.getrandbits(32))

    def default_rng(seed: Any = None) -> Any:
        return numpy.random.default_rng(source.getrandbits(128) if seed is None else seed)

    def seed(seed: Any = None) -> None:
        state.seed(source.getrandbits(32) if seed is None else seed)

    class RandomState(numpy.random.RandomState):
        """As `numpy.random.RandomState`; without a seed it is seeded from the process's generator."""

        def __init__(self, seed: Any = None) -> None:
            super().__init__(source.getrandbits(32) if seed is None else seed)

    for name in dir(state):
        if not name.startswith('_') and hasattr(numpy.random, name):
            view.__dict__[name] = getattr(state, name)
    view.__dict__.update(default_rng=default_rng, seed=seed, RandomState=RandomState)
    copy_names(view, numpy.random)
    return view
