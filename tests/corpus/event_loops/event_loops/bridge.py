import asyncio, signal, threading
import rclpy
from rclpy.node import Node
from rclpy.executors import SingleThreadedExecutor, MultiThreadedExecutor, ExternalShutdownException
from std_msgs.msg import String


class Bridge(Node):
    def __init__(self, loop):
        super().__init__('bridge')
        self.loop = loop
        self.create_timer(0.25, self.tick)
        self.create_subscription(String, 'words', self.on_word, 10)
        self.pub = self.create_publisher(String, 'words', 10)
        self.n = 0

    def tick(self):
        self.n += 1
        asyncio.run_coroutine_threadsafe(self.answer(self.n), self.loop)

    async def answer(self, n):
        await asyncio.sleep(0.1)
        self.pub.publish(String(data=f'word {n}'))

    async def on_word(self, msg):
        self.get_logger().info(f'got {msg.data}')


def ros_thread(executor):
    try:
        executor.spin()
    except ExternalShutdownException:
        pass


def main():
    rclpy.init()
    loop = asyncio.new_event_loop()
    asyncio.set_event_loop(loop)
    node = Bridge(loop)
    ex = SingleThreadedExecutor()
    ex.add_node(node)
    th = threading.Thread(target=ros_thread, args=(ex,), name='ros')
    th.start()
    loop.call_later(1.3, loop.stop)
    loop.add_signal_handler(signal.SIGTERM, loop.stop)
    try:
        loop.run_forever()
    finally:
        print('loop stopped', threading.active_count(), [t.name for t in threading.enumerate()])
        ex.shutdown(timeout_sec=1)
        node.destroy_node()
        rclpy.shutdown()
        th.join(2)
        loop.close()
        print('alive', th.is_alive())
