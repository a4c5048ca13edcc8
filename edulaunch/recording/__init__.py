"""The narrow waist: everything below produces a Recording, everything above reads one.

`records.py` says what is in it, `recorder.py` collects it from a running simulation, `recording.py` answers questions about
it, `file_format.py` writes and reads it as text that is the same byte for byte for the same run.
"""
from __future__ import annotations

from edulaunch.recording.recorder import Recorder
from edulaunch.recording.recording import Recording

__all__ = ['Recorder', 'Recording']
