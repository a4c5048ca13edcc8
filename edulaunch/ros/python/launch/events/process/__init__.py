"""Events that a process emits, and events that request something of a process."""

from typing import TYPE_CHECKING

from ..._late import late_names

if TYPE_CHECKING:
    from .process_exited import ProcessExited as ProcessExited
    from .process_io import ProcessIO as ProcessIO
    from .process_matchers import matches_executable as matches_executable
    from .process_matchers import matches_name as matches_name
    from .process_matchers import matches_pid as matches_pid
    from .process_started import ProcessStarted as ProcessStarted
    from .process_stderr import ProcessStderr as ProcessStderr
    from .process_stdin import ProcessStdin as ProcessStdin
    from .process_stdout import ProcessStdout as ProcessStdout
    from .process_targeted_event import ProcessTargetedEvent as ProcessTargetedEvent
    from .running_process_event import RunningProcessEvent as RunningProcessEvent
    from .shutdown_process import ShutdownProcess as ShutdownProcess
    from .signal_process import SignalProcess as SignalProcess
else:
    __all__, __getattr__, __dir__ = late_names(
        __name__,
        {
            'ProcessExited': 'process_exited',
            'ProcessIO': 'process_io',
            'ProcessStarted': 'process_started',
            'ProcessStderr': 'process_stderr',
            'ProcessStdin': 'process_stdin',
            'ProcessStdout': 'process_stdout',
            'ProcessTargetedEvent': 'process_targeted_event',
            'RunningProcessEvent': 'running_process_event',
            'ShutdownProcess': 'shutdown_process',
            'SignalProcess': 'signal_process',
            'matches_executable': 'process_matchers',
            'matches_name': 'process_matchers',
            'matches_pid': 'process_matchers',
        },
    )
