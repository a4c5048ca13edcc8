"""The program turtlesim_node: a window's worth of turtles, updated every 16 ms."""

from __future__ import annotations

import sys

import rclpy
from rclcpp_like import run_program
from rclpy.executors import SingleThreadedExecutor

from edulaunch.sim.task import current_task
from turtlesim._turtle_frame import TurtleFrame

TICK_NS = 16_000_000


def run() -> None:
    """Each tick: ROS work that is ready now, without waiting, then one update of all turtles."""
    frame = TurtleFrame()
    executor = SingleThreadedExecutor()
    executor.add_node(frame.node)
    task = current_task()
    context = rclpy.get_default_context()
    tick_ns = task.sim.now_ns
    while True:
        tick_ns += TICK_NS
        task.sleep_until(tick_ns)
        if not context.alive:
            return
        executor.spin_ready()
        frame.update()


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(run))


if __name__ == '__main__':
    main()
