"""The program trigger_guard_condition: a guard condition calls its callback in the executor."""

from __future__ import annotations

import rclpy
from rclpy.executors import SingleThreadedExecutor

from edulaunch.ros.running import run


def work() -> None:
    """Trigger the guard condition once, and spin until its callback has run."""
    node = rclpy.create_node('guard_condition')
    called = False

    def guard_condition_callback() -> None:
        nonlocal called
        node.get_logger().info('guard callback called')
        called = True

    executor = SingleThreadedExecutor()
    executor.add_node(node)
    guard_condition = node.create_guard_condition(guard_condition_callback)
    guard_condition.trigger()
    while rclpy.ok() and not called:
        executor.spin_once()


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(work, args)


if __name__ == '__main__':
    main()
