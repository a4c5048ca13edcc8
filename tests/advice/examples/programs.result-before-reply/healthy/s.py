import rclpy
from rclpy.node import Node
from turtlesim.srv import Spawn


class Spawner(Node):
    def __init__(self):
        super().__init__('spawner')
        self.cli = self.create_client(Spawn, '/spawn')
        while not self.cli.wait_for_service(timeout_sec=1.0):
            self.get_logger().info('waiting')
        self.timer = self.create_timer(1.0, self.go)

    def go(self):
        self.timer.cancel()
        req = Spawn.Request()
        req.x, req.y, req.name = 2.0, 2.0, 'bob'
        future = self.cli.call_async(req)
        future.add_done_callback(lambda f: self.get_logger().info('reply: %s' % f.result()))


def main(args=None):
    rclpy.init(args=args)
    node = Spawner()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
