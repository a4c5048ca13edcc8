import asyncio
import concurrent.futures
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger
from turtlesim.srv import TeleportAbsolute, SetPen
from turtlesim.msg import Pose


class AsyncTurtle(Node):
    def __init__(self):
        super().__init__('async_turtle')
        self.tele = self.create_client(TeleportAbsolute, '/turtle1/teleport_absolute')
        self.pose = asyncio.Queue(maxsize=1)
        self.sub = self.create_subscription(Pose, '/turtle1/pose', self.cb, 10)
        self.evt = asyncio.Event()
        self.loop = None

    def cb(self, m):
        if self.loop and not self.pose.full():
            self.loop.call_soon_threadsafe(self.put, m)

    def put(self, m):
        if not self.pose.full():
            self.pose.put_nowait(m)


async def spin(node):
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0)
        await asyncio.sleep(1e-3)


async def wrap(rclpy_future):
    loop = asyncio.get_running_loop()
    f = loop.create_future()
    rclpy_future.add_done_callback(lambda r: loop.call_soon_threadsafe(f.set_result, r.result()))
    return await f


async def mission(node):
    node.loop = asyncio.get_running_loop()
    while not node.tele.service_is_ready():
        await asyncio.sleep(0.1)
    for x, y in [(2, 2), (9, 2), (9, 9)]:
        await asyncio.wait_for(wrap(node.tele.call_async(TeleportAbsolute.Request(x=float(x), y=float(y)))), timeout=2.0)
        while True:
            p = await node.pose.get()
            if abs(p.x - x) < 0.01:
                break
        node.get_logger().info(f'at {p.x:.1f} {p.y:.1f}')
    res = await asyncio.gather(asyncio.to_thread(lambda: sum(range(1000))), asyncio.sleep(0.5, 'slept'),
                               node.loop.run_in_executor(None, lambda: 7))
    node.get_logger().info(str(res))
    try:
        await asyncio.wait_for(node.evt.wait(), 0.3)
    except asyncio.TimeoutError:
        node.get_logger().warn('timeout')
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        print(list(pool.map(lambda v: v ** 2, range(4))))
    first, pending = await asyncio.wait([asyncio.create_task(asyncio.sleep(d, d)) for d in (0.3, 0.1)], return_when=asyncio.FIRST_COMPLETED)
    print([t.result() for t in first], len(pending), asyncio.current_task().get_name())


async def amain():
    node = AsyncTurtle()
    spinning = asyncio.create_task(spin(node))
    try:
        await mission(node)
    finally:
        spinning.cancel()
        try:
            await spinning
        except asyncio.CancelledError:
            node.get_logger().info('spin cancelled')
        node.destroy_node()


def main(args=None):
    rclpy.init(args=args)
    asyncio.run(amain())
    rclpy.shutdown()
