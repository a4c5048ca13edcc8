"""What running one scenario came to."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

from .place import Place
from .scenario import Scenario

if TYPE_CHECKING:
    from edulaunch.recording import Recording


class Outcome(NamedTuple):
    """Either a recording, or in words why there is none.

    :param kind: 'recorded'; 'unusable' (the launch file cannot be run); 'stopped' (the run did not come to
        its end); 'broke' (the grader or the engine failed, which is never the student's loss).
    """

    scenario: Scenario
    kind: str
    recording: Recording | None = None
    text: str = ''
    try_: str | None = None
    where: Place | None = None
    sandbox: Mapping[str, str] = MappingProxyType({})  # which layers of confinement held: 'held', or why not
    detail: str = ''  # for the course author: a traceback of the engine, or what the program printed
