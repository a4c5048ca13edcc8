from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose
from learning_tf2_py.frames import placed, turned
from learning_tf2_py.program import run


class FramePublisher(Node):
    def __init__(self):
        super().__init__('turtle_tf2_frame_publisher')
        self.turtlename = self.declare_parameter('turtlename', 'turtle').value
        self.tf_broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, f'/{self.turtlename}/pose', self.handle_turtle_pose, 1)

    def handle_turtle_pose(self, msg):
        t = TransformStamped(child_frame_id=self.turtlename)
        t.header.stamp, t.header.frame_id = self.get_clock().now().to_msg(), 'world'
        t.transform.translation.x, t.transform.translation.y = msg.x, msg.y
        t.transform.rotation = turned(0.0, 0.0, msg.theta)
        self.tf_broadcaster.sendTransform(t)


def main():
    run(FramePublisher)
