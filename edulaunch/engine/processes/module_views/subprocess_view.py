"""`subprocess` of a simulated program. `ros2 ...` and programs of packages run in the simulation, and other programs run on the
real machine.
"""

from __future__ import annotations

import subprocess as real
from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.children import Child, spec_of
from edulaunch.engine.processes.module_views import copy_names

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process


def make_subprocess(view: ModuleType, process: Process) -> ModuleType:
    """Put simulated versions of the functions of `subprocess`, such as `Popen` and `run`, into a view of the module.

    `run` and the functions that use it take no simulated time for a real program. While a real program runs in the background
    (`Popen`), simulated time follows real time.
    """

    class Popen(Child):
        """The simulated `subprocess.Popen`."""

        def __init__(
            self,
            args: Any,
            bufsize: int = -1,
            executable: Any = None,
            stdin: Any = None,
            stdout: Any = None,
            stderr: Any = None,
            **options: Any,
        ) -> None:
            super().__init__(process, args, stdin=stdin, stdout=stdout, stderr=stderr, **options)

    run = _runner(process, Popen)

    def call(args: Any, **options: Any) -> int:
        code: int = run(args, **options).returncode
        return code

    def check_call(args: Any, **options: Any) -> int:
        run(args, check=True, **options)
        return 0

    def check_output(args: Any, **options: Any) -> Any:
        return run(args, stdout=real.PIPE, check=True, **options).stdout

    def getstatusoutput(cmd: str, **options: Any) -> tuple[int, str]:
        done = run(cmd, shell=True, text=True, stdout=real.PIPE, stderr=real.STDOUT, **options)
        return done.returncode, done.stdout.removesuffix('\n')

    view.__dict__.update(
        Popen=Popen,
        run=run,
        call=call,
        check_call=check_call,
        check_output=check_output,
        getstatusoutput=getstatusoutput,
        getoutput=lambda cmd, **options: getstatusoutput(cmd, **options)[1],
    )
    copy_names(view, real)
    return view


def _runner(process: Process, popen: type[Child]) -> Callable[..., Any]:
    def run(
        args: Any,
        *,
        input: Any = None,
        capture_output: bool = False,
        timeout: float | None = None,
        check: bool = False,
        **options: Any,
    ) -> Any:
        if capture_output:
            options.update(stdout=real.PIPE, stderr=real.PIPE)
        if process.host.knows(spec_of(process, args, **options)):
            child: Any = popen(args, input=input, **options)
            try:
                output = child.communicate(timeout=timeout)
            except real.TimeoutExpired:
                child.kill()
                raise
            done = real.CompletedProcess(args, child.wait(), *output)
        else:
            done = _really(process, args, input, timeout, options)
        if check:
            done.check_returncode()
        return done

    return run


def _really(process: Process, args: Any, input: Any, timeout: float | None, options: dict[str, Any]) -> Any:
    """Run a program of the real machine until it ends, and write its output to the streams of the simulated program."""
    complete = dict(options, cwd=options.get('cwd') or process.cwd, env=options.get('env') or dict(process.env))
    inherited = [stream for stream in ('stdout', 'stderr') if complete.get(stream) is None]
    complete.update(dict.fromkeys(inherited, real.PIPE))
    done = real.run(args, timeout=timeout, **complete, **({'stdin': real.DEVNULL} if input is None else {'input': input}))
    process.note(
        'real program',
        f'{process.name} ran {args if isinstance(args, str) else " ".join(map(str, args))!r}, which is a real program',
    )
    for stream in inherited:
        text = getattr(done, stream)
        setattr(done, stream, None)
        if text:
            process.write(stream, text if isinstance(text, str) else text.decode('utf-8', 'replace'))
    return done
