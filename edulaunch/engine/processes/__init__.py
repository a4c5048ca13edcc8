"""Launched programs: what to start (`spec`), what runs (`process`, whose parts are `lifecycle`, `streams`, `signals`, `limits`),
who starts it (`host`), which commands are simulated (`commands`), and the private modules of a program (`loader`).

Imports point one way: a process sees its machine by the protocol in `host_face`. Some imports stand inside functions: of files
that many runs do not need, which are `loader` (4 ms), `error_facts` (7 ms), `traceback_text` (4 ms) and `real` (5 ms); of the
modules that views stand for; and of modules that only Unix has.
"""

from __future__ import annotations

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import Origin, ProcessSpec

__all__ = ['Origin', 'Process', 'ProcessSpec', 'current_process']
