import os

import rclpy

os.environ['ROS_DOMAIN_ID'] = 'mine'
rclpy.init()
