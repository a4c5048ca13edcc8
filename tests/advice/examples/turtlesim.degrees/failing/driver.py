import rclpy
from rclpy.node import Node
from turtlesim.srv import TeleportAbsolute

rclpy.init()
node = Node('driver')
client = node.create_client(TeleportAbsolute, '/turtle1/teleport_absolute')
client.wait_for_service()
request = TeleportAbsolute.Request(x=2.0, y=2.0, theta=90.0)
rclpy.spin_until_future_complete(node, client.call_async(request))
