import os

import rclpy
from fleet_msgs.msg import MotorState, RobotState
from fleet_msgs.srv import SetMode
from rclpy.node import Node
from std_msgs.msg import Bool


class Motor(Node):
    def __init__(self, **kw):
        super().__init__('motor', **kw)
        p = lambda n, d: self.declare_parameter(n, d).value
        self.robot, self.names, self.limit = p('robot_name', 'unnamed'), p('motors', ['fl', 'fr']), p('current_limit', 3.0)
        self.log = self.get_logger()
        self.pub = self.create_publisher(RobotState, 'state', 10)
        self.srv = self.create_service(SetMode, 'set_mode', self.set_mode)
        self.sub = self.create_subscription(Bool, 'e_stop', self.e_stop, 1)
        self.t0 = self.get_clock().now()
        self.states = [MotorState(name=n, state=MotorState.STATE_IDLE) for n in self.names]
        self.create_timer(0.5, self.publish)
        self.log.info(f"{self.robot}: {self.names}, limit {self.limit}, ids {list(p('ids', [1, 2]))}, debug {p('debug', False)}, "
                      f"simulate {p('simulate', True)}, owner {p('owner', 'nobody')}, {self.sub.topic_name}, ROBOT_ID {os.environ.get('ROBOT_ID')}")

    def e_stop(self, m):
        for s in self.states:
            s.state = MotorState.STATE_FAULT if m.data else MotorState.STATE_IDLE

    def set_mode(self, request, response):
        self.log.info(f'mode {request.mode} because {request.reason!r}')
        response.accepted = request.mode in (SetMode.Request.MANUAL, SetMode.Request.AUTO)
        response.message = {True: 'ok', False: 'unknown mode'}[response.accepted]
        for s in self.states:
            s.state = MotorState.STATE_RUN
        return response

    def publish(self):
        m = RobotState(robot=self.robot)
        m.uptime = (self.get_clock().now() - self.t0).to_msg()
        for i, s in enumerate(self.states):
            s.currents = [0.5 * i, self.limit]
        m.motors = self.states
        m.motors[0].gains[1] = 0.2
        self.pub.publish(m)


def main():
    rclpy.init()
    try:
        rclpy.spin(Motor())
    except KeyboardInterrupt:
        pass
