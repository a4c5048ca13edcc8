import time
import rclpy
from std_msgs.msg import String


def main(args=None):
    rclpy.init(args=args)
    node = rclpy.create_node('sender')
    pub = node.create_publisher(String, 'news', 10)
    msg = String()
    i = 0
    while rclpy.ok():
        msg.data = 'news %d' % i
        i += 1
        pub.publish(msg)
        print('sent', msg.data)
        time.sleep(0.5)
    node.destroy_node()
    rclpy.shutdown()
