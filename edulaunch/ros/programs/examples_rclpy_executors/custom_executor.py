"""The program custom_executor: an executor that runs the callbacks of some nodes before all other callbacks."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

from rclpy.executors import Executor, TimeoutException
from rclpy.node import Node
from std_msgs.msg import String

from edulaunch.ros.running import run
from examples_rclpy_executors.listener import Listener
from examples_rclpy_executors.talker import Talker


class Estopper(Node):
    """Logs emergency stops, which must be handled immediately."""

    def __init__(self) -> None:
        super().__init__('estopper')
        self.sub = self.create_subscription(String, 'estop', self.estop_callback, 10)

    def estop_callback(self, msg: String) -> None:
        """Log the stop."""
        self.get_logger().info(f'I heard: {msg.data}')


class PriorityExecutor(Executor):
    """Runs the callbacks of high-priority nodes in a separate thread pool, and all other callbacks in a second pool."""

    def __init__(self) -> None:
        super().__init__()
        self.high_priority_nodes: set[Node] = set()
        self.hp_executor = ThreadPoolExecutor(max_workers=4)
        self.lp_executor = ThreadPoolExecutor(max_workers=1)

    def add_high_priority_node(self, node: Node) -> None:
        """Add a node whose callbacks run in the pool for high priority."""
        self.high_priority_nodes.add(node)
        self.add_node(node)

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Pass the next callback to one of the two pools."""
        try:
            handler, group, node = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
        except (StopIteration, TimeoutException):
            return
        pool = self.hp_executor if node in self.high_priority_nodes else self.lp_executor
        pool.submit(handler)


def work() -> None:
    """Spin three nodes."""
    executor = PriorityExecutor()
    executor.add_high_priority_node(Estopper())
    executor.add_node(Listener())
    executor.add_node(Talker())
    executor.spin()


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(work, args)


if __name__ == '__main__':
    main()
