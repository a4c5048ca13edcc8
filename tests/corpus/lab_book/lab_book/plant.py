from __future__ import annotations

from dataclasses import asdict, dataclass, replace
import enum

from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


@dataclass
class Gains:
    kp: float = 2.0
    ki: float = 0.0
    kd: float = 0.1


class Mode(enum.Enum):
    COLD = enum.auto()
    WARM = enum.auto()


class Plant(Node):
    def __init__(self):
        super().__init__('plant')
        step = ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=20.0, step=0.5)])
        self.gains = Gains(**{name: self.declare_parameter(f'pid.{name}', value, step if name == 'kp' else None or ParameterDescriptor()).value
                              for name, value in asdict(Gains()).items()})
        self.target = self.declare_parameter('target', 20.0).value
        self.x, self.sum, self.last, self.mode = 0.0, 0.0, None, Mode.COLD
        self.add_on_set_parameters_callback(self.check)
        self.add_post_set_parameters_callback(self.changed)
        self.pub = self.create_publisher(Float64, '~/temperature', 10)
        self.dt = 0.1
        self.create_timer(self.dt, self.step)

    def check(self, params):
        for p in params:
            if p.name == 'target' and p.value > 50.0:
                return SetParametersResult(successful=False, reason='it would boil')
        return SetParametersResult(successful=True)

    def changed(self, params):
        self.gains = replace(self.gains, **{p.name[4:]: p.value for p in params if p.name.startswith('pid.')})
        self.target = self.get_parameter('target').value
        self.get_logger().info(f'now {self.gains} {self.target}')

    def step(self):
        error = self.target - self.x
        self.sum += error * self.dt
        slope = 0.0 if self.last is None else (error - self.last) / self.dt
        self.last = error
        g = self.gains
        self.x += (g.kp * error + g.ki * self.sum + g.kd * slope - 0.2 * self.x) * self.dt
        mode = Mode.WARM if self.x > 15 else Mode.COLD
        if mode is not self.mode:
            self.get_logger().info(f'{self.mode.name} -> {mode.name}')
            self.mode = mode
        self.pub.publish(Float64(data=self.x))


def main(args=None):
    rclpy.init(args=args)
    try:
        rclpy.spin(Plant())
    except KeyboardInterrupt:
        pass
