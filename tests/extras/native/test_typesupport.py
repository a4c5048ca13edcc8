"""Classes made from text, used by the real rclpy: against itself and against its compiled classes."""

from __future__ import annotations

import signal
import subprocess
from pathlib import Path

import pytest

from edulaunch.engine.packages import Program
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.extras.native.command import HOME, description
from edulaunch.extras.native.environment import Environment
from edulaunch.runtime.session import index_for

pytestmark = pytest.mark.real
LONGEST_S = 120


def run_program(real: Environment, file: Path, *workspaces: Path) -> str:
    """Run a script as a node of a launch is run, to its end; what it printed."""
    program = Program('script', '', file.name, str(file), file=str(file))
    index = index_for(workspaces)  # what is generated for sources goes with it
    words = [
        real.python,
        f'{HOME}/edulaunch/extras/native/program.py',
        description(program, ProcessSpec(()), index, 0),
        str(file),
    ]
    done = subprocess.run(words, capture_output=True, text=True, timeout=LONGEST_S, cwd=file.parent)
    assert done.returncode == 0, done.stderr
    return done.stdout


def script(folder: Path, text: str) -> Path:
    file = folder / 'program.py'
    file.write_text(text)
    return file


def own_interfaces(folder: Path) -> Path:
    package = folder / 'ws' / 'my_msgs'
    for kind, name, text in (
        ('msg', 'Wheel', 'float32 radius\nstring<=5 name\n'),
        (
            'msg',
            'Car',
            'Wheel[4] wheels\nWheel[<=2] spare\nint8[] gears\nwstring[] words\nbool[3] lights\ngeometry_msgs/Pose pose\n',
        ),
        ('msg', 'Nothing', ''),
        ('srv', 'Drive', 'Car car\n---\nstring[] said\n'),
        ('action', 'Park', 'Car car\n---\nbool done\n---\nfloat64 left\n'),
    ):
        (package / kind).mkdir(parents=True, exist_ok=True)
        (package / kind / f'{name}.{kind}').write_text(text)
    (package / 'package.xml').write_text(
        '<package format="3"><name>my_msgs</name><version>0.0.0</version><description/><maintainer email="a@b.c">a</maintainer>'
        '<license>MIT</license><member_of_group>rosidl_interface_packages</member_of_group></package>'
    )
    listed = ' '.join(f'"{file.relative_to(package)}"' for file in sorted(package.glob('*/*')))
    (package / 'CMakeLists.txt').write_text(f'project(my_msgs)\nrosidl_generate_interfaces(my_msgs {listed})\n')
    return folder / 'ws'


THERE_AND_BACK = """
import rclpy
from my_msgs.msg import Car, Nothing, Wheel
rclpy.init()
node = rclpy.create_node('tester')
heard = []
for kind in (Car, Nothing):
    node.create_subscription(kind, kind.__name__, heard.append, 10)
car = Car(spare=[Wheel(radius=0.5, name='abcde')], gears=[1, -2], words=['\\u00e4', 'b'], lights=[True, False, True])
car.wheels[3].radius = 7.5
car.pose.position.x = 3.0
for message in (car, Nothing()):
    publisher = node.create_publisher(type(message), type(message).__name__, 10)
    while not heard:
        publisher.publish(message)
        rclpy.spin_once(node, timeout_sec=0.1)
    print(heard[0] == message, type(heard.pop()) is type(message))
    heard.clear()
    if message is car:
        print(node.get_publishers_info_by_topic('/Car')[0].topic_type_hash)
"""


def test_a_students_own_messages_go_there_and_back(real: Environment, tmp_path: Path) -> None:
    from edulaunch.engine.packages.index import interfaces_of
    from edulaunch.ros.serialization.type_description import type_hash

    workspace = own_interfaces(tmp_path)
    index = index_for([workspace])
    registry = interfaces_of(index)[1]
    expected = f'True True\n{type_hash("my_msgs/msg/Car", registry.spec)}\nTrue True\n'
    assert run_program(real, script(tmp_path, THERE_AND_BACK), workspace) == expected


SERVICE_AND_ACTION = """
import rclpy
from my_msgs.srv import Drive
from my_msgs.action import Park
from my_msgs.msg import Car, Wheel
from rclpy.action import ActionClient, ActionServer
rclpy.init()
node = rclpy.create_node('tester')

def drive(request, response):
    response.said = [wheel.name for wheel in request.car.spare]
    return response

def park(goal):
    goal.publish_feedback(Park.Feedback(left=0.5))
    goal.succeed()
    return Park.Result(done=goal.request.car.gears[0] == 3)

server, action = node.create_service(Drive, 'drive', drive), ActionServer(node, Park, 'park', park)
client, asker = node.create_client(Drive, 'drive'), ActionClient(node, Park, 'park')

def wait(future):
    rclpy.spin_until_future_complete(node, future)
    return future.result()

client.wait_for_service()
print(wait(client.call_async(Drive.Request(car=Car(spare=[Wheel(name='a'), Wheel(name='b')])))))
asker.wait_for_server()
left = []
goal = wait(asker.send_goal_async(Park.Goal(car=Car(gears=[3])), lambda message: left.append(message.feedback.left)))
print(wait(goal.get_result_async()).result, left)
"""


def test_services_and_actions_of_ones_own(real: Environment, tmp_path: Path) -> None:
    said = run_program(real, script(tmp_path, SERVICE_AND_ACTION), own_interfaces(tmp_path))
    assert said == "my_msgs.srv.Drive_Response(said=['a', 'b'])\nmy_msgs.action.Park_Result(done=True) [0.5]\n"


DESCRIPTION = """
import rclpy
from geometry_msgs.msg import PoseStamped
from rclpy.executors import MultiThreadedExecutor
from type_description_interfaces.srv import GetTypeDescription
rclpy.init()
node, other = rclpy.create_node('tester'), rclpy.create_node('asker')
publisher = node.create_publisher(PoseStamped, '/pose', 10)
while not node.get_publishers_info_by_topic('/pose'):
    rclpy.spin_once(node, timeout_sec=0.1)
kind = node.get_publishers_info_by_topic('/pose')[0]
client = other.create_client(GetTypeDescription, '/tester/get_type_description')
client.wait_for_service()
executor = MultiThreadedExecutor()
executor.add_node(node)
executor.add_node(other)
future = client.call_async(
    GetTypeDescription.Request(type_name=kind.topic_type, type_hash=str(kind.topic_type_hash), include_type_sources=True))
executor.spin_until_future_complete(future)
found = future.result()
print([field.name for field in found.type_description.type_description.fields])
print([each.type_name.split('/')[-1] for each in found.type_description.referenced_type_descriptions])
print([source.type_name for source in found.type_sources][0], 'Pose pose' in found.type_sources[0].raw_file_contents)
"""


def test_a_node_describes_its_types_to_others(real: Environment, tmp_path: Path) -> None:
    assert run_program(real, script(tmp_path, DESCRIPTION)).splitlines() == [
        "['header', 'pose']",
        "['Time', 'Point', 'Pose', 'Quaternion', 'Header']",
        'geometry_msgs/msg/PoseStamped True',
    ]


COMPILED = """
import sys
import rclpy
from builtin_interfaces.msg import Duration, Time
rclpy.init()
node = rclpy.create_node(sys.argv[1])
heard, echo = [], node.create_publisher(Duration, sys.argv[1], 10)
node.create_subscription(Duration, sys.argv[2], heard.append, 10)
while not heard or heard[-1].sec < 5:
    echo.publish(Duration(sec=heard[-1].sec + 1 if heard else 0, nanosec=7))
    rclpy.spin_once(node, timeout_sec=0.05)
for _ in range(20):  # let the other one end, too
    echo.publish(Duration(sec=9, nanosec=7))
    rclpy.spin_once(node, timeout_sec=0.05)
print(heard[0].nanosec, type(Time).__dict__.get('_TYPE_SUPPORT') is not None, hasattr(Time, 'to_wire'))
"""


def test_classes_from_text_and_compiled_ones_understand_each_other(real: Environment, tmp_path: Path) -> None:
    file = script(tmp_path, COMPILED)
    compiled = subprocess.Popen([real.python, str(file), 'plain', 'ours'], stdout=subprocess.PIPE, text=True)
    try:
        program = Program('script', '', 'x', str(file), file=str(file))
        words = [
            real.python,
            f'{HOME}/edulaunch/extras/native/program.py',
            description(program, ProcessSpec(()), index_for([]), 0),
            str(file),
        ]
        ours = subprocess.run([*words, 'ours', 'plain'], capture_output=True, text=True, timeout=LONGEST_S)
        said, _ = compiled.communicate(timeout=LONGEST_S)
    finally:
        compiled.kill()
    assert (ours.returncode, ours.stdout.split()[0], ours.stdout.split()[2]) == (0, '7', 'True'), ours.stderr
    assert (said.split()[0], said.split()[2]) == ('7', 'False')


INTERRUPTED = """
import time
import rclpy
from geometry_msgs.msg import Polygon, Point32
rclpy.init(signal_handler_options=rclpy.signals.SignalHandlerOptions.NO)
node = rclpy.create_node('tester')
publisher = node.create_publisher(Polygon, 'area', 1)
node.create_subscription(Polygon, 'area', lambda message: None, 1)
area = Polygon(points=[Point32(x=float(x)) for x in range(2000)])
came = told = 0
while told < 50:
    try:
        if came == 0:
            print('ready', flush=True)
        if told < came:
            print(came, flush=True)
            told = came
        while told < 50:
            publisher.publish(area)
            rclpy.spin_once(node, timeout_sec=0)
    except KeyboardInterrupt:
        came += 1
"""


def test_ctrl_c_waits_while_c_code_waits_for_a_message(real: Environment, tmp_path: Path) -> None:
    file = script(tmp_path, INTERRUPTED)
    program, index = Program('script', '', 'x', str(file), file=str(file)), index_for([])
    words = [
        real.python,
        f'{HOME}/edulaunch/extras/native/program.py',
        description(program, ProcessSpec(()), index, 0),
        str(file),
    ]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None and child.stderr is not None
        assert child.stdout.readline() == 'ready\n'
        for count in range(1, 51):
            child.send_signal(signal.SIGINT)
            assert child.stdout.readline() == f'{count}\n', child.stderr.read()
        assert (child.wait(LONGEST_S), 'Exception ignored' in child.stderr.read()) == (0, False)
