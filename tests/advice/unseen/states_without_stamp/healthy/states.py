import rclpy
from rclpy.node import Node
from sensor_msgs.msg import JointState


class States(Node):
    def __init__(self):
        super().__init__('states')
        self.publisher = self.create_publisher(JointState, 'joint_states', 10)
        self.create_timer(0.1, self.tell)

    def tell(self):
        message = JointState()
        message.header.stamp = self.get_clock().now().to_msg()
        message.name = ['shoulder']
        message.position = [0.5]
        self.publisher.publish(message)


def main():
    rclpy.init()
    node = States()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
