"""The components composition::Listener and composition::NodeLikeListener."""

from __future__ import annotations

from functools import partial
from typing import Any

from rclcpp_like import CppNode
from std_msgs.msg import String


class Listener(CppNode):
    """Logs what it hears on `chatter`."""

    def __init__(self, node_name: str = 'listener', **options: Any) -> None:
        super().__init__(node_name, **options)
        self._chatter = self.create_subscription(String, 'chatter', self._on_message, 10)

    def _on_message(self, message: String) -> None:
        self.get_logger().info(f'I heard: [{message.data}]')


NodeLikeListener = partial(Listener, 'node_like_listener')
