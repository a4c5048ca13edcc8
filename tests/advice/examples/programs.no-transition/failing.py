import rclpy
from rclpy.lifecycle import LifecycleNode

rclpy.init()
node = LifecycleNode('camera')
node.trigger_activate()
