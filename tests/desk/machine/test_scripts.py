"""`python3 node.py` in a terminal: on the machine of all terminals, as programs on a real computer share its ROS graph."""

from __future__ import annotations

import sys

from edulaunch.desk.cli.env import sourced_environment
from tests.desk.machine.shells import Desk, Shell

SERVER = """import sys
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


def answer(request, response):
    response.message = sys.argv[1]
    return response


rclpy.init()
node = Node('server')
node.create_service(Trigger, 'go', answer)
node.create_timer(0.1, lambda: print('tick', flush=True))
print('serving', flush=True)
rclpy.spin(node)
"""


def test_it_joins_the_machine_and_goes_with_the_clock(desk: Desk) -> None:
    (desk.folder / 'server.py').write_text(SERVER)
    script = Shell(
        'server.py', 'a word', cwd=desk.folder, env={**desk.env, **sourced_environment(desk.env)}, program=[sys.executable]
    )
    desk.shells.append(script)
    script.until('serving')
    assert desk.said('node list') == '/server\n'
    assert "message='a word'" in desk.said('service call /go std_srvs/srv/Trigger')
    script.read(0.5)
    assert script.output.count('tick') < 10_000, 'time does not pass as fast as it can'
    script.type('\x03')
    script.until('KeyboardInterrupt')
    assert script.end() == 130 and desk.said('node list') == ''
