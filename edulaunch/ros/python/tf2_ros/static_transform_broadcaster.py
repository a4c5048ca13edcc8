"""The broadcaster of transforms that do not change."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from tf2_msgs.msg import TFMessage

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.frame_owner import student_line
from edulaunch.ros.passed_on import passed_on
from tf2_ros.transform_broadcaster import as_list

if TYPE_CHECKING:
    from geometry_msgs.msg import TransformStamped
    from rclpy.node import Node


class StaticTransformBroadcaster:
    """Publishes transforms on /tf_static. Late subscriptions receive them, too. Each message repeats all transforms sent so far.

    As in Jazzy's Python version, sending a child frame again does not change its first transform.

    :param qos: the profile of the publisher; None means depth 1 and transient local.
    """

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        if qos is None:
            qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, history=HistoryPolicy.KEEP_LAST)
        self.pub_tf = node.create_publisher(TFMessage, '/tf_static', qos)
        self._sent: dict[str, TransformStamped] = {}

    def sendTransform(self, transform: TransformStamped | Iterable[TransformStamped]) -> None:  # noqa: N802
        """Publish one or several transforms, together with all earlier transforms."""
        for one in as_list(transform):
            if self._sent.setdefault(one.child_frame_id, one) is not one:
                self._note_repeated(one)
        self.pub_tf.publish(TFMessage(transforms=list(self._sent.values())))

    def _note_repeated(self, new: TransformStamped) -> None:
        """Record that a frame is sent again with other values, which no subscription will receive."""
        old = self._sent[new.child_frame_id]
        if (old.header.frame_id, old.transform) == (new.header.frame_id, new.transform):
            return
        frames = {'child': new.child_frame_id, 'parent': new.header.frame_id, 'first_parent': old.header.frame_id}
        current_process().fact('static transform repeated', new.child_frame_id, {**frames, **student_line()})


__getattr__ = passed_on(__name__)
