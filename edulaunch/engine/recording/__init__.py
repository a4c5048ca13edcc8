"""Recordings: the other packages of the engine produce a Recording, and other parts of edulaunch read it.

`records.py` defines the content, and `recorder.py` collects it from a running simulation. `recording.py` answers questions about
a recording. `file_format.py` writes and reads it as JSON lines, with the same bytes for the same run. Other parts of edulaunch
register their views of a recording in `views.py`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.engine.recording.recorder import Recorder
    from edulaunch.engine.recording.recording import Recording

__all__ = ['Recorder', 'Recording']


def __getattr__(name: str) -> Any:
    """Load a name on first use, so that code that only reads recordings does not load the recorder."""
    if name == 'Recording':
        from edulaunch.engine.recording.recording import Recording

        return Recording
    if name == 'Recorder':
        from edulaunch.engine.recording.recorder import Recorder

        return Recorder
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
