"""Recordings made by hand, and one of a real run."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, sin
from typing import Any

import pytest

import edulaunch
from edulaunch.engine.recording import Recording

START_NS = 1_700_000_000_000_000_000


class Maker:
    """Builds a recording from nodes, poses, transforms and calls."""

    def __init__(self) -> None:
        self.nodes: list[list[Any]] = []
        self.endpoints: list[list[Any]] = []
        self.columns: dict[tuple[str, str], list[tuple[int, int, list[Any]]]] = {}
        self.parameters: list[list[Any]] = []
        self.calls: list[list[Any]] = []
        self.notes: list[list[Any]] = []

    def node(
        self,
        name: str,
        *,
        publishes: dict[str, str] | None = None,
        hears: dict[str, str] | None = None,
        serves: dict[str, str] | None = None,
        calls: dict[str, str] | None = None,
        started: int = 0,
        ended: int | None = None,
    ) -> None:
        number = len(self.nodes) + 1
        self.nodes.append([name, name.strip('/') + '-1', started, ended, number])
        for kind, ends in (('publisher', publishes), ('subscription', hears), ('service', serves), ('client', calls)):
            for topic, type_name in (ends or {}).items():
                self.endpoints.append([kind, topic, type_name, number, 100 + len(self.endpoints), 0, []])

    def say(self, topic: str, type_name: str, time_s: float, wire: list[Any]) -> None:
        sender = next((row[4] for row in self.endpoints if row[0] == 'publisher' and row[1] == topic), 0)
        self.columns.setdefault((topic, type_name), []).append((round(time_s * 1e9), sender, wire))

    def pose(self, time_s: float, x: float, y: float, theta: float = 0.0, turtle: str = '/turtle1') -> None:
        self.say(f'{turtle}/pose', 'turtlesim/msg/Pose', time_s, [x, y, theta, 0.0, 0.0])

    def frame(
        self, time_s: float, parent: str, child: str, x: float, y: float, yaw: float = 0.0, z: float = 0.0, *, topic: str = '/tf'
    ) -> None:
        stamp = START_NS + round(time_s * 1e9)
        transform = [stamp // 10**9, stamp % 10**9, parent, child, x, y, z, 0.0, 0.0, sin(yaw / 2), cos(yaw / 2)]
        self.say(topic, 'tf2_msgs/msg/TFMessage', time_s, [[transform]])

    def call(self, time_s: float, service: str, type_name: str, request: list[Any]) -> None:
        time_ns = round(time_s * 1e9)
        self.calls.append([time_ns, service, type_name, '/somebody', request, True, time_ns, []])

    def done(self, duration_s: float) -> Recording:
        topics = [
            {
                'topic': topic,
                'type': kind,
                'times': [row[0] for row in rows],
                'publishers': [row[1] for row in rows],
                'messages': [row[2] for row in rows],
            }
            for (topic, kind), rows in sorted(self.columns.items())
        ]
        return Recording(
            {
                'seed': 0,
                'start_ns': START_NS,
                'duration_ns': round(duration_s * 1e9),
                'roots': [],
                'launch': {},
                'processes': [],
                'nodes': self.nodes,
                'endpoints': self.endpoints,
                'parameters': self.parameters,
                'calls': self.calls,
                'logs': [],
                'output': [],
                'notes': self.notes,
                'topics': topics,
            }
        )


POSE, TF, TWIST = 'turtlesim/msg/Pose', 'tf2_msgs/msg/TFMessage', 'geometry_msgs/msg/Twist'


@pytest.fixture
def maker() -> Maker:
    """An empty recording to fill."""
    return Maker()


@pytest.fixture
def walk(maker: Maker) -> Callable[[float, float], Recording]:
    """A turtle that walks along x at 1 m/s from (2, 3), with a tf frame of its own; made as walk(from_s, until_s)."""

    def make(from_s: float, until_s: float) -> Recording:
        maker.node('/sim', publishes={'/turtle1/pose': POSE}, hears={'/turtle1/cmd_vel': TWIST})
        maker.node('/broadcaster', publishes={'/tf': TF}, hears={'/turtle1/pose': POSE})
        for step in range(round(from_s * 50), round(until_s * 50) + 1):
            maker.pose(step / 50, 2 + step / 50, 3.0)
            maker.frame(step / 50, 'world', 'turtle1', 2 + step / 50, 3.0)
        return maker.done(until_s)

    return make


@pytest.fixture(scope='session')
def demo() -> Recording:
    """Six seconds of the tf2 demo."""
    return edulaunch.run('turtle_tf2_py', 'turtle_tf2_demo.launch.py', duration_s=6.0)
