"""A function that waits for one message of a topic."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.engine.sim.task import current_task
from edulaunch.ros.passed_on import passed_on
from rclpy.impl.refusals import without_context
from rclpy.node_parts.core import core_of
from rclpy.qos import QoSProfile, engine_qos, validate_qos
from rclpy.type_support import check_is_valid_msg_type

if TYPE_CHECKING:
    from rclpy.node import Node


def wait_for_message(
    msg_type: Any, node: Node, topic: str, *, qos_profile: QoSProfile | int = 1, time_to_wait: float = -1
) -> tuple[bool, Any]:
    """Wait for the next message of a topic. The caller need not spin the node.

    :param time_to_wait: the longest wait in simulated seconds; -1 means no limit.
    :returns: (True, the message), or (False, None) if the time has passed or ROS 2 was shut down during the wait.
    :raises RCLError: when ROS 2 was shut down before the call.
    """
    core = core_of(node)
    check_is_valid_msg_type(msg_type)
    task = current_task()
    impl = core.graph.create_subscription(
        core.entry, core.resolve(topic, 'topic'), msg_type, engine_qos(validate_qos(qos_profile), 'subscription'), task.wake
    )
    if not core.context.alive:
        impl.destroy()
        raise without_context('failed to initialize wait set')
    deadline = None if time_to_wait < 0 else task.sim.now_ns + int(time_to_wait * 1e9)
    try:
        while not impl.queue and core.context.alive and (deadline is None or task.sim.now_ns < deadline):
            core.context.rcl_park(deadline)
        taken = impl.take()
    finally:
        impl.destroy()
    return (False, None) if taken is None else (True, msg_type.from_wire(taken[0]))


__getattr__ = passed_on(__name__)
