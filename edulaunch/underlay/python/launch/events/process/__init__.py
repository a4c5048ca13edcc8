"""What can happen to processes."""

from ..._lazy import lazy_exports

_EXPORTS = {
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
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
