"""The program composed: a talker and a listener in one program, spun by one executor."""

from __future__ import annotations

from rclpy.executors import SingleThreadedExecutor

from edulaunch.ros.running import run
from examples_rclpy_executors.listener import Listener
from examples_rclpy_executors.talker import Talker


def work() -> None:
    """Spin both nodes."""
    executor = SingleThreadedExecutor()
    executor.add_node(Talker())
    executor.add_node(Listener())
    executor.spin()


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(work, args)


if __name__ == '__main__':
    main()
