"""The frame around a C++ program's main: how it starts, is interrupted and dies."""

from __future__ import annotations

from collections.abc import Callable

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.logging import get_logger

from edulaunch.processes.current import current_process
from edulaunch.processes.signals import Signals
from rclcpp_like.errors import cpp_name_of


def run_program(main: Callable[[], int | None]) -> int:
    """Run `main` between rclpy's init and shutdown, and answer the exit code a C++ program would have.

    Ctrl-C is said in the log and ends the program well. An exception that C++ has too is printed the way its
    runtime does, and aborts (signal 6).
    """
    try:
        rclpy.init()
        return main() or 0
    except KeyboardInterrupt:
        get_logger('rclcpp').info('signal_handler(signum=2)')
    except ExternalShutdownException:
        pass
    except Exception as error:
        name = cpp_name_of(error)
        if name is None:
            raise
        process = current_process()
        text = f"terminate called after throwing an instance of '{name}'\n  what():  {error}\n"
        process.write('stderr', text)
        process.exit_now(-Signals.SIGABRT)
    finally:
        rclpy.try_shutdown()
    return 0
