"""The listener, which receives transforms."""

from __future__ import annotations

import sys
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from tf2_msgs.msg import TFMessage

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.frame_owner import student_line
from edulaunch.ros.node_facts import core_of
from edulaunch.ros.passed_on import passed_on
from tf2_ros.buffer import wire_receiver

if TYPE_CHECKING:
    from rclpy.node import Node

    from tf2_ros.buffer import Buffer

AUTHORITY = 'default_authority'


class TransformListener:
    """Fills a buffer from /tf and /tf_static. Store the listener (`self.tf_listener = ...`), because it stops when Python deletes
    it.

    :param spin_thread: whether to spin the node in a separate thread, so that transforms arrive during a lookup with a timeout.
    :param qos: the profile for /tf; None means depth 100.
    :param static_qos: the profile for /tf_static; None means depth 100 and transient local.
    """

    def __init__(
        self,
        buffer: Buffer,
        node: Node,
        *,
        spin_thread: bool = False,
        qos: QoSProfile | int | None = None,
        static_qos: QoSProfile | int | None = None,
    ) -> None:
        if qos is None:
            qos = QoSProfile(depth=100, durability=DurabilityPolicy.VOLATILE, history=HistoryPolicy.KEEP_LAST)
        if static_qos is None:
            static_qos = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_LAST)
        self.node = node
        self.group = ReentrantCallbackGroup()
        self.tf_sub: Any = node.create_subscription(TFMessage, '/tf', _nowhere, qos, callback_group=self.group)
        self.tf_static_sub: Any = node.create_subscription(
            TFMessage, '/tf_static', _nowhere, static_qos, callback_group=self.group
        )
        self.buffer = buffer
        self._line = student_line()
        self.executor: Any = None
        if spin_thread:
            self._start_thread()

    @property
    def buffer(self) -> Buffer:
        """The buffer that the listener fills. A program can replace it."""
        return self._buffer

    @buffer.setter
    def buffer(self, buffer: Buffer) -> None:
        self._buffer = buffer
        # The callbacks refer to the buffer, not to the listener, so that the listener ends when it is deleted. A subclass's own
        # callback refers to the listener.
        own = type(self).callback is not TransformListener.callback
        own_static = type(self).static_callback is not TransformListener.static_callback
        self.tf_sub.callback = self.callback if own else _receiver(buffer.set_transform)
        self.tf_static_sub.callback = self.static_callback if own_static else _receiver(buffer.set_transform_static)
        receive_wire = wire_receiver(buffer, AUTHORITY)
        if receive_wire is not None and not own:
            self.tf_sub.rcl_take_wires(receive_wire)

    def callback(self, data: TFMessage) -> None:
        """Put the transforms of a /tf message into the buffer. Subclasses may override this method."""
        _receiver(self.buffer.set_transform)(data)

    def static_callback(self, data: TFMessage) -> None:
        """Put the transforms of a /tf_static message into the buffer. Subclasses may override this method."""
        _receiver(self.buffer.set_transform_static)(data)

    def _start_thread(self) -> None:
        from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor

        self.executor = executor = SingleThreadedExecutor()
        node = self.node

        def run() -> None:
            executor.add_node(node)
            with suppress(ExternalShutdownException):
                executor.spin()
            executor.remove_node(node)

        # the module of this process, whose threads run in simulated time
        threading = current_process().loader.import_('threading')
        self.dedicated_listener_thread = threading.Thread(target=run)
        self.dedicated_listener_thread.start()

    def __del__(self) -> None:
        if getattr(self, 'executor', None) is not None:
            self.executor.shutdown()
        if getattr(self, 'tf_sub', None) is not None and not sys.is_finalizing():
            _note_dropped(self.node, getattr(self, '_line', {}))
        self.unregister()

    def unregister(self) -> None:
        """Stop listening."""
        for name in ('tf_sub', 'tf_static_sub'):
            subscription = getattr(self, name, None)
            if subscription is not None:
                setattr(self, name, None)
                self.node.destroy_subscription(subscription)


def _note_dropped(node: Node, line: dict[str, Any]) -> None:
    """Record that Python deleted a listener whose node still exists, because no variable refers to the listener."""
    core = core_of(node)
    if not core.destroyed and core.context.alive and core.process.returncode is None:
        core.process.fact('listener dropped', core.full_name, {'node': core.full_name, **line})


def _nowhere(message: TFMessage) -> None:
    """Do nothing. The subscriptions have this callback until there is a buffer."""


def _receiver(set_transform: Any) -> Any:
    def receive(message: TFMessage) -> None:
        for transform in message.transforms:
            set_transform(transform, AUTHORITY)

    return receive


__getattr__ = passed_on(__name__)
