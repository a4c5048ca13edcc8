import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


class Chain(Node):
    """Adds by asking somebody else."""

    def __init__(self):
        super().__init__('chain')
        group = ReentrantCallbackGroup()
        self.cli = self.create_client(AddTwoInts, 'add', callback_group=group)
        self.srv = self.create_service(AddTwoInts, 'chained_add', self.answer, callback_group=group)
        self.timer = self.create_timer(0.4, self.tick, callback_group=group)
        self.n = 0

    async def answer(self, request, response):
        self.get_logger().info('passing on')
        inner = await self.cli.call_async(AddTwoInts.Request(a=request.a, b=request.b))
        response.sum = inner.sum * 10
        return response

    async def tick(self):
        self.n += 1
        if self.n == 2:
            self.timer.cancel()
            got = await self.cli.call_async(AddTwoInts.Request(a=1, b=1))
            self.get_logger().info('timer got %d' % got.sum)


def main():
    rclpy.init()
    rclpy.spin(Chain())
