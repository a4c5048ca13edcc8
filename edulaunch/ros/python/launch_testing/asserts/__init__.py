"""Assertions about the output and the exit codes of processes."""

from ..util.proc_lookup import NO_CMD_ARGS
from .assert_exit_codes import EXIT_OK, EXIT_SIGINT, EXIT_SIGKILL, EXIT_SIGQUIT, EXIT_SIGSEGV, assertExitCodes
from .assert_output import assertInStderr, assertInStdout, assertInStream
from .assert_sequential_output import SequentialTextChecker, assertSequentialStdout

__all__ = [
    'NO_CMD_ARGS',
    'EXIT_OK',
    'EXIT_SIGINT',
    'EXIT_SIGKILL',
    'EXIT_SIGQUIT',
    'EXIT_SIGSEGV',
    'assertExitCodes',
    'assertInStderr',
    'assertInStdout',
    'assertInStream',
    'SequentialTextChecker',
    'assertSequentialStdout',
]
