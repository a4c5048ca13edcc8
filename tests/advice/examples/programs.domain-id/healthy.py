import os

import rclpy

os.environ['ROS_DOMAIN_ID'] = '42'
rclpy.init()
