import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn


class Camera(LifecycleNode):
    def on_configure(self, state):
        self.get_logger().info('configured')
        return TransitionCallbackReturn.SUCCESS


rclpy.init()
camera = Camera('camera')
camera.trigger_configure()
camera.trigger_activate()
rclpy.spin(camera)
