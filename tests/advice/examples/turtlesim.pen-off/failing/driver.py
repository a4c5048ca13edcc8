import rclpy
from rclpy.node import Node
from turtlesim.srv import SetPen

rclpy.init()
node = Node('driver')
client = node.create_client(SetPen, '/turtle1/set_pen')
client.wait_for_service()
request = SetPen.Request(r=255, width=3, off=1)
rclpy.spin_until_future_complete(node, client.call_async(request))
