from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener


class FrameWatcher:
    """Hears all transforms on behalf of a node, and answers where things are."""

    def __init__(self, node):
        self.node = node
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, node)

    def find(self, target, seen_from):
        """Where the frame `target` is, as seen from another one; None if tf cannot tell."""
        try:
            t = self.buffer.lookup_transform(seen_from, target, Time())
        except TransformException as error:
            text = f'Could not transform {seen_from} to {target}: {error}'
            self.node.get_logger().info(text, throttle_duration_sec=2.0)
            return None
        return t.transform.translation
