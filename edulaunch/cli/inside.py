"""`ros2 ...` inside the simulation: reads the command and the verb, and loads that command's file only."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.errors import EdulaunchError

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

INTERRUPTED = 2
"""What the `ros2` command returns after Ctrl-C: the number of the signal."""


def main(process: Process) -> int:
    """Run the command line of `process` (`process.argv`, 'ros2' first) inside it; returns its exit code.

    As in ROS 2 a verb's error text goes to standard error with status 1, and wrong usage has status 2.
    """
    from edulaunch.cli.ros2.parser import command_line

    try:
        verb, arguments = command_line(process.argv[1:])
        return _exit_code(process, verb.main(arguments))
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else 0
    except KeyboardInterrupt:
        return INTERRUPTED
    except (EdulaunchError, RuntimeError) as error:
        return _exit_code(process, str(error))


def _exit_code(process: Process, outcome: Any) -> int:
    """A verb returns None or a number, or the text of its error."""
    if isinstance(outcome, str):
        process.stderr.write(outcome + '\n')
        return 1
    return int(outcome or 0)
