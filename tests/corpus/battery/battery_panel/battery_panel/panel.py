import rclpy
from led_interfaces.msg import LedStates
from led_interfaces.srv import SetLed
from rclpy.node import Node


class Panel(Node):

    def __init__(self):
        super().__init__('panel')
        self.declare_parameter('leds', [False, False, False])
        self.leds = self.get_parameter('leds').value
        self.pub = self.create_publisher(LedStates, 'led_states', 10)
        self.timer = self.create_timer(4, self.publish)
        self.server = self.create_service(SetLed, 'set_led', self.on_set_led)

    def publish(self):
        msg = LedStates()
        msg.states = self.leds
        self.pub.publish(msg)

    def on_set_led(self, request: SetLed.Request, response: SetLed.Response):
        if request.number >= len(self.leds):
            response.success = False
            response.message = f'there are {len(self.leds)} LEDs, at most {SetLed.Request.MOST} are possible'
            return response
        self.leds[request.number] = request.on
        self.publish()
        self.get_logger().info(str(self.leds))
        response.success = True
        return response


def main(args=None):
    rclpy.init(args=args)
    node = Panel()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
