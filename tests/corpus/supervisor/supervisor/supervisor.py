import rclpy
from rcl_interfaces.msg import Log, Parameter, ParameterEvent, ParameterType, ParameterValue
from rcl_interfaces.srv import GetParameters, SetParameters
from rclpy.node import Node
from rclpy.parameter import parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient


class Supervisor(Node):
    def __init__(self):
        super().__init__('supervisor')
        self.create_subscription(Log, '/rosout', self.on_log, 10)
        self.create_subscription(ParameterEvent, '/parameter_events', self.on_event, 10)
        self.setter = self.create_client(SetParameters, '/worker/set_parameters')
        self.getter = self.create_client(GetParameters, '/worker/get_parameters')
        self.timer = self.create_timer(1.0, self.step)
        self.steps = 0

    def step(self):
        self.steps += 1
        if self.steps == 1:
            value = ParameterValue(type=ParameterType.PARAMETER_DOUBLE, double_value=4.5)
            self.setter.call_async(SetParameters.Request(parameters=[Parameter(name='speed', value=value)]))
        elif self.steps == 2:
            self.getter.call_async(GetParameters.Request(names=['speed', 'name'])).add_done_callback(self.got)
        elif self.steps == 3:
            client = AsyncParameterClient(self, 'worker')
            client.wait_for_services()
            client.set_parameters([rclpy.Parameter('speed', value='fast')]).add_done_callback(
                lambda f: self.get_logger().info(f.result().results[0].reason))

    def got(self, future):
        print([parameter_value_to_python(value) for value in future.result().values])

    def on_log(self, msg):
        if msg.name != 'supervisor':
            print('log of', msg.name, ':', msg.msg, msg.level == Log.WARN[0] if isinstance(Log.WARN, bytes) else msg.level)

    def on_event(self, event):
        if event.node == '/worker':
            for p in event.changed_parameters:
                print('changed', p.name, p.value.double_value)


def main():
    rclpy.init()
    rclpy.spin(Supervisor())
