"""Launched programs: descriptions (`spec`), running processes (`process` with its parts `lifecycle`, `streams`, `signals`,
`limits`), and the host that starts them (`host`). `commands` finds the simulated commands, and `loader` loads the private
modules of a program.

Imports point in one direction: a process uses its machine only through the protocol in `host_face`. Some imports are inside
functions. These imports load files that many runs do not need: `loader` (4 ms), `error_facts` (7 ms), `traceback_text` (4
ms) and `real` (5 ms). Other imports load modules that views replace, or modules that only Unix has.
"""

from __future__ import annotations

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import Origin, ProcessSpec

__all__ = ['Origin', 'Process', 'ProcessSpec', 'current_process']
