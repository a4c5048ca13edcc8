"""Launch files that reach into their own process for marks: they find only the confined peer, and gain nothing.

Each is a circle whose node is not told the radius (which leaves 5 of 12 points: the default has no effect), and does something more.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.grading import grade, plan_work
from edugrade.results import GRADER_BROKE, Report
from edugrade.submission import Submission

CIRCLE = (Path(__file__).parents[2] / 'solutions' / 'circle.launch.py').read_text()
LAZY = CIRCLE.replace("        parameters=[{'radius': LaunchConfiguration('circle_radius')}],\n", '')
HONEST = 5

PEER = """
import gc, json, posix, struct
peer = next(one for one in gc.get_objects() if type(one).__name__ == 'Peer')
session = next(one for one in gc.get_objects() if type(one).__name__ == 'ConfinedSession')
def frame(kind, *values):
    peer._add(kind, json.dumps(values if len(values) > 1 else values[0]).encode())
"""
LATER = """
from launch.actions import OpaqueFunction, TimerAction
_generate = generate_launch_description
def generate_launch_description():
    return LaunchDescription([*_generate().entities, TimerAction(period=1.0, actions=[OpaqueFunction(function=lambda context: do() or [])])])
"""
SHIPPED = "path = session.index.find_executable('part3_beyond_basics', 'param_circle.py')\n"
ATTACKS = {
    'hosts everything itself': PEER + "session.host.start.__globals__['is_hosted'] = lambda program: False\n",
    'hosts the robot itself': PEER
    + "session.host.start.__globals__['is_hosted'] = lambda program: 'waffle' not in program.executable\n",
    'sends a recording': "import posix\nposix.write(3, b'R' + (5).to_bytes(8, 'big') + b'[[]]\\n')\nposix._exit(0)\n",
    'says that edulaunch broke': "import posix\nposix.write(3, b'B' + (2).to_bytes(8, 'big') + b'{}')\nposix._exit(0)\n",
    'ends like a good one': 'import posix\nposix._exit(0)\n',
    'kills the trusted peer': 'import posix\ntry:\n    posix.kill(posix.getppid(), 9)\nexcept OSError:\n    pass\n',
    'looks into the trusted peer': """
import posix
for name in ('mem', 'environ', 'maps', 'fd/3'):
    try:
        posix.open(f'/proc/{posix.getppid()}/{name}', posix.O_RDWR)
        posix._exit(0)
    except OSError:
        pass
""",
    'claims the program': PEER
    + SHIPPED
    + """
frame(17, 1002, [[path], 'circle', None, {}, False, None, 'part3_beyond_basics', 'param_circle.py', {}, False, False])
""",
    'sets the parameter for the node': PEER
    + LATER
    + """
def do():
    for node in session.graph.nodes:
        frame(16, node.index, 'radius', float(session.launches[0].arguments['circle_radius']), 'launch argument')
""",
    'has a node of the same name': PEER
    + LATER
    + """
def do():
    radius = float(session.launches[0].arguments['circle_radius'])
    index = session.graph.next_index()
    frame(5, index, 1001, 'my_param_circle_node', '/')
    frame(16, index, 'radius', radius, 'launch argument')
""",
    'is the odometry': PEER
    + LATER
    + """
def do():
    pub = next(pub for pub in session.graph.publishers['/odom'])
    peer._add(9, struct.pack('<I', pub.index) + b'\\x02[]')
""",
    'publishes odometry': PEER
    + LATER
    + """
import math
def do():
    radius = float(session.launches[0].arguments['circle_radius'])
    node, end = session.graph.next_index(), session.graph.next_index()
    frame(5, node, 1001, 'robot', '/')
    frame(7, 'publisher', end, node, '/odom', 'nav_msgs/msg/Odometry', list(session.graph.publishers['/odom'][0].qos))
    from nav_msgs.msg import Odometry
    for step in range(400):
        message = Odometry()
        message.pose.pose.position.x = radius * math.cos(step / 20)
        message.pose.pose.position.y = radius * math.sin(step / 20)
        peer._add(9, struct.pack('<I', end) + b'\\x02' + json.dumps(Odometry.to_wire(message), default=list).encode())
""",
    'goes ahead in time': PEER + "peer._add(3, struct.pack('<q', session.sim.now_ns + 10**9))\n",
    'never answers': 'import _thread\nlock = _thread.allocate_lock()\nlock.acquire()\nlock.acquire()\n',
    'floods': PEER + "while True:\n    frame(21, None, 'x', 'y' * 1000000)\n",
    'leaves half a frame': PEER + "peer._end.sendall(b'\\xff\\x00\\x00\\x00\\x15abc')\nposix._exit(0)\n",
}


def graded(folder: Path, text: str, limit_s: float = 8.0) -> Report:
    from edugrade.job import Limits

    file = folder / 'circle.launch.py'
    file.write_text(text)
    work = plan_work(Submission(str(file)), seed=5)
    return next(grade([work], Limits(limit_s)))


@pytest.mark.processes
def test_without_the_trick_it_has_its_honest_points(tmp_path: Path) -> None:
    assert graded(tmp_path, LAZY).earned == HONEST


@pytest.mark.whole
@pytest.mark.parametrize('name', ATTACKS)
def test_a_trick_earns_nothing(tmp_path: Path, name: str) -> None:
    report = graded(tmp_path, LAZY + ATTACKS[name], 2.0 if name == 'never answers' else 8.0)
    broke = any(result.status == GRADER_BROKE for result in report.results)
    assert (report.earned or 0) <= HONEST
    assert not broke
