"""What runs inside a simulated process: an entry point's function, or a script as `__main__`."""
from __future__ import annotations

from edulaunch.packages import Program
from edulaunch.processes.process import Process


def run_program(process: Process, program: Program) -> object:
    """Run `program` with the process's private modules; returns what its main function returned."""
    loader = process.loader
    loader.roots.extend(program.python_roots)
    if program.kind == 'script':
        loader.run_file(program.file, '__main__', script=True)
        return None
    module = loader.load_entry_module(program.module)
    function = module
    for name in program.function.split('.'):
        function = getattr(function, name)
    return function()  # type: ignore[operator]
