"""Numbers by chance that repeat from run to run: the generator is seeded by the run's seed and the program."""

from __future__ import annotations

from random import Random
from typing import Any

import numpy

from edulaunch.processes.current import current_process


def numbers(size: int) -> Any:
    """So many numbers from 0 to 1, as an array."""
    process = current_process()
    generator: Random = process.state.setdefault('tf_transformations', process.sim.random(f'{process.name}/tf_transformations'))
    return numpy.array([generator.random() for _ in range(size)])
