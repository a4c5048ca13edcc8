import rclpy
from rclpy.node import Node
from turtlesim.srv import Kill

rclpy.init()
node = Node('driver')
client = node.create_client(Kill, '/kill')
client.wait_for_service()
request = Kill.Request(name='turtle1')
rclpy.spin_until_future_complete(node, client.call_async(request))
