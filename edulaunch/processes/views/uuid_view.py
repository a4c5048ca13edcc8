"""`uuid` that repeats: random identifiers come from the process's seed."""

from __future__ import annotations

import uuid as real
from types import ModuleType
from typing import TYPE_CHECKING

from edulaunch.processes.views import copy_names

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


def make(view: ModuleType, process: Process) -> ModuleType:
    """`uuid1` and `uuid4` draw from a generator seeded by (simulation seed, process name)."""
    generator = process.sim.random(f'{process.name}/uuid')

    def uuid4() -> real.UUID:
        return real.UUID(int=generator.getrandbits(128), version=4)

    def uuid1(node: int | None = None, clock_seq: int | None = None) -> real.UUID:
        return real.UUID(int=generator.getrandbits(128), version=1)

    view.__dict__.update(uuid1=uuid1, uuid4=uuid4, getnode=lambda: 0x0242AC110002)
    copy_names(view, real)
    return view
