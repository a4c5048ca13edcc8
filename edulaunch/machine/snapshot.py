"""A recording of a machine that goes on running."""

from __future__ import annotations

from copy import deepcopy

from edulaunch.recording import Recording
from edulaunch.session import Session


def glance(session: Session) -> Recording:
    """What happened until now, to be read before time goes on."""
    recorder = session.recorder
    session.describe()
    recorder.stop()
    content = recorder.content()
    recorder.on = True
    return Recording(content)


def snapshot(session: Session) -> Recording:
    """What happened until now. Later events do not change it, and are kept for the next snapshot."""
    content = glance(session)._content
    content.update({part: deepcopy(value) for part, value in content.items() if part != 'topics'})
    return Recording(content)
