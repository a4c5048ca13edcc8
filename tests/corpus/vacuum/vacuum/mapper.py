"""Where we have been, as an occupancy grid that latecomers get, too."""
import numpy as np
import rclpy
from nav_msgs.msg import MapMetaData, OccupancyGrid, Odometry
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile


class Mapper(Node):
    def __init__(self):
        super().__init__('mapper')
        self.grid = np.full((6, 6), -1, dtype=np.int8)
        self.info = MapMetaData(resolution=0.5, width=6, height=6)
        self.info.origin.position.x = self.info.origin.position.y = -1.5
        self.pub = self.create_publisher(OccupancyGrid, 'map', QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))
        self.create_subscription(Odometry, 'odom', self.on_odom, 10)

    def on_odom(self, msg):
        p = msg.pose.pose.position
        cell = int((p.y + 1.5) // 0.5), int((p.x + 1.5) // 0.5)
        if self.grid[cell] != 0:
            self.grid[cell] = 0
            grid = OccupancyGrid(info=self.info)
            grid.header.frame_id = 'odom'
            grid.data = self.grid.flatten()
            self.pub.publish(grid)
            self.get_logger().info('cell %s, %d of %d clean' % (cell, np.count_nonzero(self.grid == 0), self.grid.size))


def main():
    rclpy.init()
    rclpy.spin(Mapper())
