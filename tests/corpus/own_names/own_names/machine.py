from dataclasses import dataclass, field
from enum import Enum, auto
from typing import List, Optional
import json
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class State(Enum):
    IDLE = auto()
    BUSY = auto()


@dataclass
class Job:
    name: str
    steps: List[int] = field(default_factory=list)
    owner: Optional[str] = None


class Counting:
    def __init__(self, *args, **kwargs):
        super().__init__(*args, **kwargs)
        self._count = 0

    def count(self):
        self._count += 1
        return self._count


class Machine(Counting, Node):
    def __init__(self):
        super().__init__('machine')
        self._timers = []
        self._publishers = []
        self._context = self._executor = self._handle = None
        self.name = 'not the node name'
        self.state = State.IDLE
        self.job = Job('clean', [1, 2])
        self.pub = self.create_publisher(String, 'jobs', 10)
        self.sub = self.create_subscription(String, 'jobs', self.heard, 10)
        self.declare_parameter('speed', 2)
        self._timers.append(self.create_timer(0.5, self.step))

    @staticmethod
    def heard(msg):
        print('job', json.loads(msg.data))

    def step(self):
        self.state = State.BUSY if self.state is State.IDLE else State.IDLE
        self.pub.publish(String(data=json.dumps({'name': self.job.name, 'n': self.count(), 'state': self.state.name})))
        print(self.get_name(), self.get_parameter('speed').value, self.count_publishers('jobs'))
        if self._count == 3:
            self.timers = []


def main():
    rclpy.init()
    rclpy.spin(Machine())
