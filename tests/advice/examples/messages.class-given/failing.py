import rclpy
from rclpy.node import Node
from std_srvs.srv import SetBool, Trigger

rclpy.init()
node = Node('robot')
node.create_service(SetBool, 'lamp', lambda request, response: response)
client = node.create_client(SetBool, 'lamp')
future = client.call_async(SetBool.Request)
rclpy.spin_until_future_complete(node, future, timeout_sec=1.0)
