"""The program of each real process: `python program.py INPUT ARGV...` in the environment of the real rclpy.

INPUT is JSON with these entries:

- `parent`: the process with which the program ends, or a file that this process keeps locked
- `home`: the folder of edulaunch
- `path`: further folders for imports
- `interfaces`: layers of share folders
- `program`: a :class:`edulaunch.engine.packages.reading.Program`
"""

from __future__ import annotations

import json
import os
import runpy
import sys
from importlib import import_module
from typing import Any


def main() -> None:
    """Prepare the process, and run the program."""
    description = json.loads(sys.argv[1])
    sys.argv[:] = sys.argv[2:]
    sys.path[:1] = []  # the folder of this file
    sys.path.extend([description['home'], *description['path']])
    from edulaunch.extras.native.ending import end_with

    end_with(description['parent'])
    from edulaunch.extras.native import adapter, engine
    from edulaunch.extras.native.typesupport import classes

    program = description['program']
    process = engine.install(program['name'])
    classes.install(description['interfaces'])
    adapter.install(os.path.join(description['home'], 'edulaunch', 'ros', 'python'))
    sys.exit(_run(program, process))


def _run(program: dict[str, Any], process: Any) -> Any:
    """Run the program like an executable of a package. It is the function of an entry point, or a file or module as
    `__main__`.
    """
    sys.path[:0] = program['python_roots']  # before Python's own folders, like PYTHONPATH
    kind, file, module = program['kind'], program['file'], program['module']
    if kind == 'ros2':
        from edulaunch.desk.cli.ros2.commands import main as ros2

        return ros2(process)
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
