import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformListener
from geometry_msgs.msg import TransformStamped

rclpy.init()
node = Node('robot')
buffer = Buffer()
listener = TransformListener(buffer, node)
transform = TransformStamped(child_frame_id='map')
transform.header.frame_id = 'world'
transform.transform.rotation.w = 1.0
broadcaster = StaticTransformBroadcaster(node)
broadcaster.sendTransform(transform)
rclpy.spin_once(node)
buffer.can_transform('world', 'map', Time(), timeout=Duration(seconds=1.0))
