"""The large-project launch against real time, and against a bare loop that does the same arithmetic and deliveries."""

from __future__ import annotations

import math
import random
import struct
import time
from pathlib import Path
from typing import Any

import edulaunch

LAUNCH_FILE = Path(__file__).with_name('large_project.launch.py')
TICK_NS = 16_000_000


def engine(seconds: float) -> tuple[float, int]:
    """Processor seconds to run the launch file with recording on, after its start-up, and how many messages were published."""
    with edulaunch.Session() as session:
        session.launch(LAUNCH_FILE)
        session.run(3.0)
        before = session.recorder.publication_count()
        began = time.process_time()
        session.run(seconds)
        took = time.process_time() - began
        return took, session.recorder.publication_count() - before


class Bare:
    """The same work in plain calls: worlds, messages, snapshots, transforms; no clock, no tasks, no graph, no executors."""

    def __init__(self) -> None:
        edulaunch.source()
        from geometry_msgs.msg import TransformStamped, Twist
        from tf2_msgs.msg import TFMessage
        from tf2_ros import Buffer
        from turtlesim.msg import Pose

        from edulaunch.engine.worlds.turtle_world import TurtleWorld

        self.worlds = [TurtleWorld(random.Random(0)) for _ in range(2)]
        for world in self.worlds:
            world.spawn_first()
        self.worlds[0].spawn(4.0, 2.0, 0.0, 'turtle2')
        self.pose, self.twist, self.tf_message, self.stamped = Pose, Twist, TFMessage, TransformStamped
        self.buffer: Any = Buffer()
        self.records: list[tuple[int, int, Any]] = []
        self.now_ns = 1_700_000_000_000_000_000
        self.pack = struct.Struct('5f')

    def run(self, seconds: float) -> int:
        """Simulate; returns the number of messages."""
        for tick in range(round(seconds * 62.5)):
            self.now_ns += TICK_NS
            for number, world in enumerate(self.worlds):
                world.update(self.now_ns)
                for turtle in world.turtles:
                    self.publish_turtle(number, turtle)
            if tick % 6 == 0:
                self.broadcast('turtle1', 'carrot1', 0.0, 2.0, 0.0)
            if tick % 62 == 61:
                self.follow()
        return len(self.records)

    def publish_turtle(self, number: int, turtle: Any) -> None:
        wire = self.pack.unpack(self.pack.pack(turtle.x, turtle.y, turtle.theta, turtle.linear_velocity, turtle.turning))
        self.records.append((self.now_ns, 1, wire))
        self.records.append((self.now_ns, 2, turtle.color))
        if number == 0:
            pose = self.pose.from_wire(wire)
            self.broadcast('world', turtle.name, pose.x, pose.y, pose.theta)
            if turtle.name == 'turtle2':
                self.mimic(self.pose.from_wire(wire))

    def broadcast(self, parent: str, child: str, x: float, y: float, theta: float) -> None:
        stamped = self.stamped()
        stamped.header.frame_id = parent
        stamped.child_frame_id = child
        stamped.header.stamp.sec, stamped.header.stamp.nanosec = divmod(self.now_ns, 10**9)
        stamped.transform.translation.x = x
        stamped.transform.translation.y = y
        stamped.transform.rotation.z = math.sin(theta / 2.0)
        stamped.transform.rotation.w = math.cos(theta / 2.0)
        wire = self.tf_message.to_wire(self.tf_message(transforms=[stamped]))
        self.records.append((self.now_ns, 3, wire))
        for transform in self.tf_message.from_wire(wire).transforms:
            self.buffer.set_transform(transform, 'bare')

    def mimic(self, pose: Any) -> None:
        twist = self.twist()
        twist.linear.x = pose.linear_velocity
        twist.angular.z = pose.angular_velocity
        wire = self.twist.to_wire(twist)
        self.records.append((self.now_ns, 4, wire))
        heard = self.twist.from_wire(wire)
        self.worlds[1].turtles[0].command(heard.linear.x, heard.angular.z, self.now_ns)

    def follow(self) -> None:
        from rclpy.time import Time

        found = self.buffer.lookup_transform('turtle2', 'carrot1', Time()).transform.translation
        twist = self.twist()
        twist.angular.z = math.atan2(found.y, found.x)
        twist.linear.x = 0.5 * math.sqrt(found.x**2 + found.y**2)
        wire = self.twist.to_wire(twist)
        self.records.append((self.now_ns, 5, wire))
        heard = self.twist.from_wire(wire)
        self.worlds[0].turtles[1].command(heard.linear.x, heard.angular.z, self.now_ns)


def bare(seconds: float) -> tuple[float, int]:
    """Seconds (wall clock) of the bare loop, and how many messages it made."""
    loop = Bare()
    began = time.process_time()
    count = loop.run(seconds)
    return time.process_time() - began, count


def measure(seconds: float = 20.0, rounds: int = 5) -> dict[str, float]:
    """Medians of interleaved rounds: times real time, times the cost of the bare loop, messages of both."""
    pairs = [(engine(seconds), bare(seconds)) for _ in range(rounds)]
    times = sorted(pair[0][0] for pair in pairs)
    ratios = sorted(pair[0][0] / pair[1][0] for pair in pairs)
    return {
        'times real time': seconds / times[rounds // 2],
        'times the bare loop': ratios[rounds // 2],
        'messages': pairs[0][0][1],
        'messages of the bare loop': pairs[0][1][1],
    }


if __name__ == '__main__':
    for name, value in measure().items():
        print(f'{name}: {value:.1f}')
