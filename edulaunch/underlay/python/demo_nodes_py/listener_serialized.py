"""The program listener_serialized: logs the bytes of what it hears on `chatter`."""

from __future__ import annotations

from rclpy.node import Node
from std_msgs.msg import String

from demo_nodes_py._running import spin


class SerializedListener(Node):
    """Asks for messages as they travel, undecoded."""

    def __init__(self) -> None:
        super().__init__('serialized_subscriber')
        self._chatter = self.create_subscription(String, 'chatter', self._on_bytes, 10, raw=True)

    def _on_bytes(self, serialized: bytes) -> None:
        self.get_logger().info(f'I heard: "{serialized!r}"')


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(SerializedListener)


if __name__ == '__main__':
    main()
