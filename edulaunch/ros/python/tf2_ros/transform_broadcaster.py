"""The broadcaster of transforms that change."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from geometry_msgs.msg import TransformStamped
from rclpy.qos import QoSProfile
from tf2_msgs.msg import TFMessage

from edulaunch.ros.passed_on import passed_on

if TYPE_CHECKING:
    from rclpy.node import Node

_to_wire = TransformStamped.to_wire


class TransformBroadcaster:
    """Publishes transforms on /tf.

    :param qos: the profile of the publisher; None means depth 100.
    """

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        self.pub_tf = node.create_publisher(TFMessage, '/tf', QoSProfile(depth=100) if qos is None else qos)

    def sendTransform(self, transform: TransformStamped | Iterable[TransformStamped]) -> None:  # noqa: N802
        """Publish one transform, or several transforms in one message.

        For a single transform, the usual case, no TFMessage object is created. The wire tuple of a TFMessage contains the wire
        tuples of its transforms.
        """
        publisher = self.pub_tf
        if transform.__class__ is TransformStamped and publisher.context.alive:
            publisher.send_wire(((_to_wire(transform),),))
        else:
            publisher.publish(TFMessage(transforms=as_list(transform)))


def as_list(transform: TransformStamped | Iterable[TransformStamped]) -> list[TransformStamped]:
    """Return a list for an argument that is one transform or several transforms."""
    return list(transform) if hasattr(transform, '__iter__') else [transform]


__getattr__ = passed_on(__name__)
