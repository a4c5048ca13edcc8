"""The network as a service of the machine: whether it is available, and the function that creates it and loads the bridge."""

from __future__ import annotations

import selectors
from importlib.util import find_spec
from typing import TYPE_CHECKING

from edulaunch.engine.sim.pacing import RealTime
from edulaunch.runtime.session import Session

if TYPE_CHECKING:
    from edulaunch.extras.network.switch import Switch


def is_available() -> bool:
    """Return whether Cyclone DDS is installed. A page needs it for the button with which a machine joins."""
    return find_spec('cyclonedds') is not None


def make(session: Session, time: RealTime, selector: selectors.BaseSelector) -> Switch:
    """Return the network of one machine. The network is off at first."""
    from edulaunch.extras.network.switch import Switch

    return Switch(session, time, selector)
