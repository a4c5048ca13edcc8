"""Launched programs: what to start (`spec`), what runs (`process`), who starts it (`host`), its private modules (`loader`)."""

from __future__ import annotations

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import Origin, ProcessSpec

__all__ = ['Origin', 'Process', 'ProcessSpec', 'current_process']
