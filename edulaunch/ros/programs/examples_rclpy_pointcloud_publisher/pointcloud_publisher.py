"""The program pointcloud_publisher: it publishes a wave of 100 times 100 points, 30 times a second."""

from __future__ import annotations

import numpy as np
from rclpy.node import Node
from sensor_msgs.msg import PointCloud2, PointField
from sensor_msgs_py import point_cloud2
from std_msgs.msg import Header

from edulaunch.ros.running import spin

RATE_HZ = 30
SIDE_M = 2.0


class PointCloudPublisher(Node):
    """Publishes point clouds on `test_cloud`, in the frame `map`."""

    def __init__(self) -> None:
        super().__init__('pc_publisher')
        self._publisher = self.create_publisher(PointCloud2, 'test_cloud', 10)
        self._width = self._height = 100
        self._fields = [
            PointField(name=name, offset=4 * place, datatype=PointField.FLOAT32, count=1)
            for place, name in enumerate(('x', 'y', 'z', 'intensity'))
        ]
        self._counter = 0
        self._timer = self.create_timer(1 / RATE_HZ, self.timer_callback)

    def timer_callback(self) -> None:
        """Publish the next state of the wave."""
        self._counter += 1
        x, y = np.meshgrid(np.linspace(-SIDE_M, SIDE_M, self._width), np.linspace(-SIDE_M, SIDE_M, self._height))
        z = 0.5 * np.sin(2 * x - self._counter / 10.0) * np.sin(2 * y)
        points = np.array([x, y, z, z]).reshape(4, -1).T
        header = Header(frame_id='map', stamp=self.get_clock().now().to_msg())
        self._publisher.publish(point_cloud2.create_cloud(header, self._fields, points))


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    spin(PointCloudPublisher, args)


if __name__ == '__main__':
    main()
