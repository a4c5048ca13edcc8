"""The interfaces that come with edulaunch."""

from __future__ import annotations

import os
from functools import cache

from edulaunch.interfaces.registry import Registry


@cache
def underlay_registry() -> Registry:
    """The one registry of the underlay's interfaces. Its files never change while a program runs, so all
    simulations share it.
    """
    here = os.path.dirname(os.path.abspath(__file__))
    return Registry([os.path.join(os.path.dirname(here), 'underlay', 'share')])
