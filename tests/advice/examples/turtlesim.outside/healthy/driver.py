import rclpy
from rclpy.node import Node
from turtlesim.srv import Spawn

rclpy.init()
node = Node('driver')
client = node.create_client(Spawn, '/spawn')
client.wait_for_service()
request = Spawn.Request(x=2.0, y=2.0, name='turtle2')
rclpy.spin_until_future_complete(node, client.call_async(request))
