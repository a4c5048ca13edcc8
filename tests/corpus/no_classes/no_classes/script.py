import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node('script')
publisher = node.create_publisher(msg_type=String, topic='/words', qos_profile=10)
for word in 'three old words'.split():
    publisher.publish(msg=String(data=word))
heard = []
subscription = node.create_subscription(String, '/words', heard.append, 10)
for number in range(2):
    publisher.publish(msg=String(data='new %d' % number))
    rclpy.spin_once(node, timeout_sec=0)
print([m.data for m in heard])
node.destroy_publisher(publisher=publisher)
node.destroy_subscription(subscription)
rclpy.shutdown()


def main():
    print('main comes after it all')
