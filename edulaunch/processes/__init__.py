"""Launched programs: what to start (`spec`), what runs (`process`), who starts it (`host`), its private modules (`loader`)."""

from __future__ import annotations

from edulaunch.processes.current import current_process
from edulaunch.processes.process import Process
from edulaunch.processes.spec import Origin, ProcessSpec

__all__ = ['Origin', 'Process', 'ProcessSpec', 'current_process']
