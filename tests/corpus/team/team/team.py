import rclpy
from rclpy.executors import SingleThreadedExecutor
from team.base.robot import Robot
from .helpers import GREETINGS, describe


class Walker(Robot):
    def __init__(self):
        super().__init__('walker')
        self.create_timer(1.0, self.greet)


class Flyer(Robot):
    def __init__(self):
        super().__init__('flyer', namespace='sky')
        self.create_timer(0.7, self.greet)
        self.get_logger().info(describe(self) + ' ' + GREETINGS[1])


def main(args=None):
    rclpy.init(args=args)
    try:
        walker, flyer = Walker(), Flyer()
        executor = SingleThreadedExecutor()
        executor.add_node(walker)
        executor.add_node(flyer)
        try:
            executor.spin()
        finally:
            executor.shutdown()
            walker.destroy_node()
            flyer.destroy_node()
    finally:
        rclpy.shutdown()
