"""The notebook's own asyncio loop, set aside while simulated time passes."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

from edulaunch.sim.loops import put_back, set_aside


@contextmanager
def outer_loop_set_aside() -> Iterator[None]:
    """Let simulated programs run as if no loop ran around them, and give the notebook its loop back afterwards.

    A launch that goes on living is left in the middle of a loop of its own; without this the kernel would take that one, or none,
    for the loop that runs.
    """
    hooks, outer = sys.get_asyncgen_hooks(), set_aside()
    try:
        yield
    finally:
        put_back(outer)
        sys.set_asyncgen_hooks(*hooks)
