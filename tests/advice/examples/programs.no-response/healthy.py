import rclpy
from rclpy.node import Node
from std_srvs.srv import SetBool


class Lamp(Node):
    def __init__(self):
        super().__init__('lamp')
        self.create_service(SetBool, 'lamp', self.switch)
        self.client = self.create_client(SetBool, 'lamp')

    def switch(self, request, response):
        response.success = request.data
        return response


rclpy.init()
lamp = Lamp()
future = lamp.client.call_async(SetBool.Request(data=True))
rclpy.spin_until_future_complete(lamp, future, timeout_sec=1.0)
