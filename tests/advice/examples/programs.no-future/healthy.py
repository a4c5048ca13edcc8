import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty

rclpy.init()
node = Node('robot')
node.create_service(Empty, 'rest', lambda request, response: response)
client = node.create_client(Empty, 'rest')
client.wait_for_service()
rclpy.spin_until_future_complete(node, client.call_async(Empty.Request()), timeout_sec=1.0)
