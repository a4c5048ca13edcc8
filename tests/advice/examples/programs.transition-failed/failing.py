import rclpy
from rclpy.lifecycle import LifecycleNode


class Camera(LifecycleNode):
    def on_configure(self, state):
        self.get_logger().info('configured')


rclpy.init()
camera = Camera('camera')
camera.trigger_configure()
rclpy.spin(camera)
