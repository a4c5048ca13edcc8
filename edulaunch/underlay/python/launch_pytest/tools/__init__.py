"""Waiting for what processes do and write."""

from launch._lazy import lazy_exports

_WORDS = (
    'wait_for_output',
    'wait_for_stdout',
    'wait_for_stderr',
    'wait_for_start',
    'wait_for_exit',
    'assert_output',
    'assert_stdout',
    'assert_stderr',
)
_EXPORTS = {'process': '', **{name + end: 'process' for name in _WORDS for end in ('', '_sync')}}
__all__ = list(_EXPORTS)
__getattr__, __dir__ = lazy_exports(__name__, _EXPORTS)
