"""Spins a node while a test runs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.node import Node


class MessagePump:
    """Spins a node in a thread of the test's process until it is stopped. The class can be used in a `with` block.

    :param context: the context of the node; None means the default context.
    """

    def __init__(self, node: Node, timeout: float = 10, context: Context | None = None) -> None:
        from rclpy.executors import SingleThreadedExecutor

        self._node = node
        self._timeout_s = timeout
        self._executor: Any = SingleThreadedExecutor(context=context)
        self._running = False
        self._task: Any = None

    def __enter__(self) -> MessagePump:
        self.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    def start(self) -> None:
        """Start to spin the node."""
        self._executor.add_node(self._node)
        self._running = True
        self._task = current_process().start_thread(self._spin, 'message_pump', daemon=True)

    def stop(self) -> None:
        """Stop spinning. Wait at most `timeout` simulated seconds for running callbacks.

        :raises RuntimeError: when a callback has not ended in time.
        """
        from edulaunch.engine.sim.sync import sleep

        self._running = False
        self._executor.wake()
        waited_s = 0.0
        while not self._task.finished and waited_s < self._timeout_s:
            sleep(0.01)
            waited_s += 0.01
        if not self._task.finished:
            raise RuntimeError('Timed out waiting for message pump to stop')
        self._executor.remove_node(self._node)
        self._executor.shutdown()

    def _spin(self) -> None:
        while self._running:
            self._executor.spin_once(timeout_sec=1.0)
