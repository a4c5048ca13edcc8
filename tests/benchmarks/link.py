"""What the link costs: the same launch in one process and in two peers, in turns, and how much longer one message takes.

The student's node hears each pose of turtlesim (62.5 a second, hosted in the trusted peer) and answers with a velocity, so that
each pose is a turn of the confined peer: the worst case, two switches of processes for three messages. The recordings are the
same bytes.
"""

from __future__ import annotations

import os
import signal
import socket
import tempfile
import time
from pathlib import Path

from edulaunch.engine.recording import Recording
from edulaunch.runtime.link.confined import ConfinedSession
from edulaunch.runtime.link.trusted import Trusted
from edulaunch.runtime.session import Session

ROUNDS = 7
DURATION_S = 60.0
FILES = {
    'chaser/package.xml': """<package format="3"><name>chaser</name><version>0.0.1</version><description>x</description>
<maintainer email="a@b.c">a</maintainer><license>MIT</license><export><build_type>ament_python</build_type></export></package>
""",
    'chaser/setup.cfg': '[install]\ninstall_scripts=$base/lib/chaser\n',
    'chaser/setup.py': """from setuptools import setup
setup(name='chaser', version='0.0.1', packages=['chaser'], entry_points={'console_scripts': ['chase = chaser.chase:main']})
""",
    'chaser/chaser/__init__.py': '',
    'chaser/chaser/chase.py': """import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.msg import Pose


class Chase(Node):
    def __init__(self):
        super().__init__('chase')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_subscription(Pose, '/turtle1/pose', self.heard, 10)

    def heard(self, pose):
        message = Twist()
        message.linear.x, message.angular.z = 1.0, 0.5
        self.publisher.publish(message)


def main():
    rclpy.init()
    rclpy.spin(Chase())
""",
    'chase.launch.py': """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node'), Node(package='chaser', executable='chase')])
""",
}


def alone(folder: Path) -> Recording:
    """The launch in one process."""
    with Session(workspaces=[folder]) as session:
        session.launch(folder / 'chase.launch.py')
        session.run(DURATION_S)
        return session.recording()


def linked(folder: Path) -> Recording:
    """The launch in two peers."""
    ours, theirs = socket.socketpair()
    pid = os.fork()
    if pid == 0:
        ours.close()
        session = ConfinedSession(theirs, workspaces=[folder])
        session.launch(folder / 'chase.launch.py')
        session.run_as_asked()
    theirs.close()
    try:
        return Recording(Trusted(ours, 0).run(DURATION_S))
    finally:
        ours.close()
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)


def main() -> None:
    """Print the best of some rounds."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for path, text in FILES.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text)
        best: dict[str, float] = {}
        digests = set()
        for _ in range(ROUNDS):
            for way in (alone, linked):
                began = time.perf_counter()
                recording = way(folder)
                best[way.__name__] = min(best.get(way.__name__, 1e9), time.perf_counter() - began)
                digests.add(recording.digest())
        count = sum(topic.count for topic in recording.topics.values())
        more = (best['linked'] - best['alone']) / count
        print(f'{count} messages in {DURATION_S:g} simulated s: alone {best["alone"]:.3f} s, linked {best["linked"]:.3f} s')
        print(
            f'{more * 1e6:.0f} us more for each message; {"the same recording" if len(digests) == 1 else "DIFFERENT recordings"}'
        )


if __name__ == '__main__':
    main()
