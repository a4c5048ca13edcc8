from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener


class FrameWatcher:
    """Receives all transforms for a node, and looks up where frames are."""

    def __init__(self, node):
        self.node = node
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, node)

    def find(self, target, seen_from):
        """Return the position of `target` as seen from another frame, or None."""
        try:
            t = self.buffer.lookup_transform(seen_from, target, Time())
        except TransformException as error:
            text = f'Could not transform {seen_from} to {target}: {error}'
            self.node.get_logger().info(text, throttle_duration_sec=2.0)
            return None
        return t.transform.translation
