"""Small things for launch tests."""

from launch._lazy import lazy_exports

_EXPORTS = {
    'KeepAliveProc': 'keep_alive_proc',
    'NO_CMD_ARGS': 'proc_lookup',
    'NoMatchingProcessException': 'proc_lookup',
    'resolveProcesses': 'proc_lookup',
}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
