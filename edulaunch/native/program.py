"""What runs in each real process: `python program.py TOLD ARGV...` in the environment of the real rclpy.

TOLD is JSON: `parent` (the process with which it ends; 0: none), `home` (the folder of edulaunch), `path` (further
folders for imports), `interfaces` (layers of share folders) and `program` (which :class:`edulaunch.packages.reading.Program`).
"""

from __future__ import annotations

import ctypes
import json
import os
import runpy
import signal
import sys
from importlib import import_module
from typing import Any

DISCOVERY_NS = 3_000_000_000
"""A command of ros2 that finds no daemon listens so much longer than in the simulation: who misses the first announcements of a
node hears the next one after three seconds."""
_PR_SET_PDEATHSIG = 1
"""Of Linux's prctl(2)."""


def main() -> None:
    """Make everything ready, and run the program."""
    told = json.loads(sys.argv[1])
    _end_with(told['parent'])
    sys.argv[:] = sys.argv[2:]
    sys.path[:1] = []  # the folder of this file
    sys.path.extend([told['home'], *told['path']])
    from edulaunch.native import adapter, engine
    from edulaunch.native.typesupport import classes

    program = told['program']
    process = engine.install(program['name'])
    classes.install(told['interfaces'])
    adapter.install(os.path.join(told['home'], 'edulaunch', 'underlay', 'python'))
    sys.exit(_run(program, process))


def _end_with(parent: int) -> None:
    """Let the system end this process when its parent ends in whatever way, be it by SIGKILL."""
    if not parent:
        return
    ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:  # it has ended before
        sys.exit(1)


def _run(program: dict[str, Any], process: Any) -> Any:
    """As an executable of a package runs: the function of an entry point, or a file or module as `__main__`."""
    sys.path[:0] = [root for root in program['python_roots'] if root not in sys.path]  # as PYTHONPATH: before Python's own
    kind, file, module = program['kind'], program['file'], program['module']
    if kind == 'ros2':
        if sys.argv[1:3] == ['bag', 'record']:
            return 'ros2 bag record takes its messages from the simulation: leave out --real, or record with an installed ROS 2'
        from edulaunch.attached import attached

        process.sim.start_ns += DISCOVERY_NS
        return attached('ros2')(process)
    if kind == 'script':
        sys.path.insert(0, os.path.dirname(os.path.realpath(file)))
        return runpy.run_path(file, run_name='__main__') and None
    if kind == 'module':
        sys.path.insert(0, program['python_roots'][0])
        return runpy.run_module(module, run_name='__main__', alter_sys=True) and None
    function: Any = import_module(module)
    for name in program['function'].split('.'):
        function = getattr(function, name)
    return function()


if __name__ == '__main__':
    main()
