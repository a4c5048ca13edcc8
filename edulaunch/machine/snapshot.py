"""A recording of a machine that goes on running."""

from __future__ import annotations

from copy import deepcopy

from edulaunch.recording import Recording
from edulaunch.session import Session


def snapshot(session: Session) -> Recording:
    """What happened until now. Later events do not change it, and are kept for the next snapshot."""
    recorder = session.recorder
    session.describe()
    recorder.stop()
    content = recorder.content()
    content.update({part: deepcopy(value) for part, value in content.items() if part != 'topics'})
    recorder.on = True
    return Recording(content)
