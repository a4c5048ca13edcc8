import rclpy
from rclpy.node import Node
from functools import partial
from turtlesim.msg import Pose
from turtlesim.srv import Spawn


class Watch(Node):
    def __init__(self):
        super().__init__('watch')
        self.poses = {}
        self.subs = {}
        self.create_timer(1.0, self.look)
        spawn = self.create_client(Spawn, 'spawn')
        spawn.wait_for_service()
        for i, name in enumerate(['leo', '', 'leo']):
            request = Spawn.Request(x=1.0 + i, y=90.0, theta=0.0, name=name)
            future = spawn.call_async(request)
            rclpy.spin_until_future_complete(self, future)
            print('spawned %r' % future.result().name)

    def look(self):
        for topic, types in self.get_topic_names_and_types():
            if 'turtlesim/msg/Pose' in types and topic not in self.subs:
                print('new:', topic)
                self.subs[topic] = self.create_subscription(
                    Pose, topic, lambda msg, name=topic: self.heard(msg, name), 10)
                self.create_subscription(Pose, topic, partial(self.quiet, topic), 1)
        print(self.count_publishers('turtle1/pose'), self.count_subscribers('/turtle1/pose'),
              sorted(n for n in self.get_node_names()))

    def heard(self, msg, name):
        print('%s at %.2f %.2f' % (name, msg.x, msg.y))
        self.destroy_subscription(self.subs[name])

    def quiet(self, topic, msg):
        pass


def main():
    rclpy.init()
    rclpy.spin(Watch())
