import math
import random
import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.msg import Pose
from turtlesim.srv import Kill, SetPen, Spawn, TeleportAbsolute


class Hunter(Node):
    def __init__(self):
        super().__init__('hunter')
        self.cli_spawn = self.create_client(Spawn, 'spawn')
        self.cli_kill = self.create_client(Kill, 'kill')
        self.pub = self.create_publisher(Twist, '/hunter/cmd_vel', 10)
        self.pose = None
        self.prey = {}
        self.caught = 0

    def call(self, client, **fields):
        while not client.wait_for_service(timeout_sec=1.0):
            self.get_logger().info('service not available, waiting again...')
        request = client.srv_type.Request(**fields)
        future = client.call_async(request)
        rclpy.spin_until_future_complete(self, future)
        return future.result()

    def setup(self):
        self.call(self.cli_kill, name='turtle1')
        self.call(self.cli_spawn, x=5.5, y=5.5, theta=0.0, name='hunter')
        self.call(self.create_client(SetPen, '/hunter/set_pen'), r=255, g=0, b=0, width=2, off=0)
        self.create_subscription(Pose, '/hunter/pose', self.on_pose, 10)
        for i in range(3):
            name = f'prey{i}'
            self.call(self.cli_spawn, x=random.uniform(1, 10), y=random.uniform(1, 10), theta=0.0, name=name)
            self.create_subscription(Pose, f'/{name}/pose', lambda msg, name=name: self.on_prey(name, msg), 10)
        self.create_timer(0.05, self.hunt)

    def on_pose(self, msg):
        self.pose = msg

    def on_prey(self, name, msg):
        if name is not None:
            self.prey[name] = (msg.x, msg.y)

    def hunt(self):
        if self.pose is None or not self.prey:
            return
        name, (x, y) = min(self.prey.items(), key=lambda item: math.dist(item[1], (self.pose.x, self.pose.y)))
        distance = math.dist((x, y), (self.pose.x, self.pose.y))
        cmd = Twist()
        if distance < 0.4:
            self.caught += 1
            self.get_logger().info(f'caught {name}')
            self.cli_kill.call_async(Kill.Request(name=name)).add_done_callback(
                lambda future, name=name: self.prey.pop(name, None))
            if self.caught == 3:
                raise SystemExit(0)
        else:
            error = math.atan2(y - self.pose.y, x - self.pose.x) - self.pose.theta
            error = math.atan2(math.sin(error), math.cos(error))
            cmd.linear.x = min(3.0, 2 * distance)
            cmd.angular.z = 5 * error
        self.pub.publish(cmd)


def main():
    rclpy.init()
    hunter = Hunter()
    hunter.setup()
    try:
        rclpy.spin(hunter)
    except SystemExit:
        print('all caught')
    finally:
        hunter.destroy_node()
        rclpy.shutdown()
