import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.srv = self.create_service(Empty, 'nothing', lambda q, a: a)
        self.future = self.create_client(Empty, 'nothing').call_async(Empty.Request())
        self.future.add_done_callback(self.done)

    def done(self, future):
        self.get_logger().info('done %s' % future.result())
        rclpy.shutdown()


def main():
    rclpy.init()
    rclpy.spin(Asker())
    print('left')
