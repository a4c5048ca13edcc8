"""The network as a service of the machine: whether it is available, and the function that creates it. The function loads the
bridge.
"""

from __future__ import annotations

import selectors
from importlib.util import find_spec
from typing import TYPE_CHECKING

from edulaunch.engine.sim.pacing import RealTime
from edulaunch.runtime.session import Session

if TYPE_CHECKING:
    from edulaunch.extras.network.switch import Switch


def is_available() -> bool:
    """Return whether Cyclone DDS is installed, which the button of a page needs to join."""
    return find_spec('cyclonedds') is not None


def make(session: Session, time: RealTime, selector: selectors.BaseSelector) -> Switch:
    """Return the network of one machine, switched off."""
    from edulaunch.extras.network.switch import Switch

    return Switch(session, time, selector)
