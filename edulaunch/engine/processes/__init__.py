"""Launched programs: descriptions (`spec`), running processes (`process` with its parts `lifecycle`, `streams`, `signals`,
`limits`), and the host that starts them (`host`). `commands` has the simulated commands, and `loader` the private modules of a
program.

Imports point one way: a process knows its machine only by the protocol in `host_face`. Some imports are inside functions. They
are for files that many runs do not need: `loader` (4 ms), `error_facts` (7 ms), `traceback_text` (4 ms) and `real` (5 ms). Others
are for modules that views replace, and for modules that only Unix has.
"""

from __future__ import annotations

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import Origin, ProcessSpec

__all__ = ['Origin', 'Process', 'ProcessSpec', 'current_process']
