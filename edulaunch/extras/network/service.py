"""The network as a service of the machine: whether it can be had, and what makes it. The bridge itself is loaded only then."""

from __future__ import annotations

import selectors
from importlib.util import find_spec
from typing import TYPE_CHECKING

from edulaunch.engine.sim.pacing import RealTime
from edulaunch.runtime.session import Session

if TYPE_CHECKING:
    from edulaunch.extras.network.switch import Switch


def is_available() -> bool:
    """Whether Cyclone DDS, which the button of a page joins by, is installed."""
    return find_spec('cyclonedds') is not None


def make(session: Session, time: RealTime, selector: selectors.BaseSelector) -> Switch:
    """The network of one machine, switched off."""
    from edulaunch.extras.network.switch import Switch

    return Switch(session, time, selector)
