"""The full link, with programs on the real rclpy as peers: topics, services and actions both ways, graph, QoS, echoes, its end."""

from __future__ import annotations

import os
import select
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.graph.qos import BEST_EFFORT, QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.packages import Index, Program
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.extras.native import environment
from edulaunch.extras.native.command import command
from edulaunch.extras.network.network_link import (
    CLIENT,
    PUBLISHER,
    SERVICE,
    SUBSCRIPTION,
    Event,
    Interface,
    LinkDiagnostic,
    LinkError,
    Message,
    RemoteGraph,
    Request,
    Response,
    Settings,
)
from edulaunch.extras.network.rclpy_link import RclpyLink
from edulaunch.ros.serialization.cdr import deserialize, serialize
from tests.extras.network.wires import own_domain

pytestmark = pytest.mark.real
LONGEST_S = 60.0
REGISTRY = underlay_registry()


@pytest.fixture
def number() -> Iterator[int]:
    """The number of a domain for the test alone."""
    if environment.found() is None:
        pytest.skip('the real rclpy is not installed: edulaunch network install')
    with own_domain() as number:
        yield number


@pytest.fixture
def link(number: int) -> Iterator[RclpyLink]:
    made = RclpyLink()
    made.open(Settings(number))
    yield made
    made.close()


@pytest.fixture
def peer(link: RclpyLink, number: int, tmp_path: Path) -> Iterator[Callable[[str], subprocess.Popen[str]]]:
    """Start a program on the real rclpy."""
    started: list[subprocess.Popen[str]] = []

    def start(text: str) -> subprocess.Popen[str]:
        file = tmp_path / f'peer{len(started)}.py'
        file.write_text('import rclpy\nrclpy.init()\nnode = rclpy.create_node("peer")\n' + text)
        program = Program('script', '', 'peer', str(file), file=str(file))
        words = command(environment.needed(), program, ProcessSpec((), 'peer'), Index())
        env = {**os.environ, 'ROS_DOMAIN_ID': str(number), 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST'}
        started.append(subprocess.Popen([*words, str(file)], env=env, stdout=subprocess.PIPE, text=True))
        return started[-1]

    yield start
    for child in started:
        child.kill()
        child.communicate()


def until(link: RclpyLink, done: Callable[[list[Event]], Any], each: Callable[[], object] = lambda: None) -> list[Event]:
    """Take events until they are enough."""
    events: list[Event] = []
    end = time.monotonic() + LONGEST_S
    while not done(events):
        assert time.monotonic() < end, events
        each()
        link.flush()
        select.select([link.fileno()], [], [], 0.05)
        events += link.take()
    return events


def of(kind: type[Any], events: list[Event]) -> list[Any]:
    return [event for event in events if isinstance(event, kind)]


def interface(name: str) -> Interface:
    return Interface(name, REGISTRY)


def message(type_name: str, /, **fields: Any) -> Any:
    return REGISTRY.get(type_name)(**fields)


def test_topics_both_ways_and_who_is_there(link: RclpyLink, peer: Callable[[str], Any]) -> None:
    node = link.add_node('/ns', 'ours')
    heard = link.add(node, SUBSCRIPTION, '/back', interface('geometry_msgs/msg/Twist'), QoS(depth=5))
    said = link.add(node, PUBLISHER, '/there', interface('turtlesim/msg/Pose'), QoS(depth=5))
    peer("""
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose
back = node.create_publisher(Twist, '/back', 5)
def answer(pose):
    twist = Twist()
    twist.linear.x = pose.x + 1.0
    back.publish(twist)
node.create_subscription(Pose, '/there', answer, 5)
rclpy.spin(node)
""")
    pose = serialize(message('turtlesim/msg/Pose', x=41.0))
    events = until(link, lambda events: of(Message, events), lambda: link.publish(said, pose))
    came = of(Message, events)[0]
    assert (came.handle, came.gid) == (heard, b'')
    assert deserialize(came.cdr, REGISTRY.get('geometry_msgs/msg/Twist')).linear.x == 42.0
    assert abs(came.source_ns - time.time_ns()) < LONGEST_S * 1e9
    until(link, lambda _: (end := _end_of(link.graph(), 'subscription', '/there')) is not None and end.node is not None)
    end = _end_of(link.graph(), 'subscription', '/there')
    assert (end.type_name, end.hash, end.node.name) == ('turtlesim/msg/Pose', interface('turtlesim/msg/Pose').hash, 'peer')
    assert (end.qos.reliability, end.qos.durability) == ('reliable', 'volatile')
    assert [node.name for node in link.graph().nodes] == ['peer']
    assert _end_of(link.graph(), 'publisher', '/there') is None, 'what is ours is not remote'


def _end_of(graph: RemoteGraph, kind: str, name: str) -> Any:
    return next((end for end in graph.endpoints if (end.kind, end.name) == (kind, name)), None)


def test_a_real_client_is_served(link: RclpyLink, peer: Callable[[str], Any]) -> None:
    node = link.add_node('/', 'sim')
    service = link.add(node, SERVICE, '/spawn', interface('turtlesim/srv/Spawn'), QoS())
    child = peer("""
from turtlesim.srv import Spawn
client = node.create_client(Spawn, '/spawn')
client.wait_for_service()
futures = [client.call_async(Spawn.Request(x=float(number), name='leo')) for number in range(3)]
for future in futures:
    rclpy.spin_until_future_complete(node, future)
    print(future.result().name)
""")
    requests = of(Request, until(link, lambda events: len(of(Request, events)) == 3))
    assert {request.handle for request in requests} == {service}
    for request in reversed(requests):  # in any order: each reply finds its request
        asked = deserialize(request.cdr, REGISTRY.get('turtlesim/srv/Spawn_Request'))
        link.reply(service, request.who, serialize(message('turtlesim/srv/Spawn_Response', name=f'{asked.name}{asked.x:g}')))
    link.flush()
    assert child.communicate(timeout=LONGEST_S)[0] == 'leo0\nleo1\nleo2\n'


def test_a_real_server_is_asked(link: RclpyLink, peer: Callable[[str], Any]) -> None:
    node = link.add_node('/', 'asker')
    client = link.add(node, CLIENT, '/sum', interface('example_interfaces/srv/AddTwoInts'), QoS())
    peer("""
from example_interfaces.srv import AddTwoInts
def add(request, response):
    response.sum = request.a + request.b
    return response
node.create_service(AddTwoInts, '/sum', add)
rclpy.spin(node)
""")
    until(link, lambda _: _end_of(link.graph(), 'service', '/sum'))
    request = serialize(message('example_interfaces/srv/AddTwoInts_Request', a=2, b=3))
    numbers = iter(range(7, 1000))
    events = until(link, lambda events: of(Response, events), lambda: link.request(client, next(numbers), request))
    answer = of(Response, events)[0]
    assert answer.handle == client and answer.number >= 7
    assert deserialize(answer.cdr, REGISTRY.get('example_interfaces/srv/AddTwoInts_Response')).sum == 5


def test_parameter_services_carry_rclpys_own_messages(link: RclpyLink, peer: Callable[[str], Any]) -> None:
    node = link.add_node('/', 'sim')
    service = link.add(node, SERVICE, '/sim/set_parameters', interface('rcl_interfaces/srv/SetParameters'), QoS())
    child = peer("""
from rcl_interfaces.srv import SetParameters
from rclpy.parameter import Parameter
client = node.create_client(SetParameters, '/sim/set_parameters')
client.wait_for_service()
future = client.call_async(SetParameters.Request(parameters=[Parameter('background_r', value=200).to_parameter_msg()]))
rclpy.spin_until_future_complete(node, future)
print(future.result().results[0].reason)
""")
    request = of(Request, until(link, lambda events: of(Request, events)))[0]
    asked = deserialize(request.cdr, REGISTRY.get('rcl_interfaces/srv/SetParameters_Request'))
    assert (asked.parameters[0].name, asked.parameters[0].value.integer_value) == ('background_r', 200)
    result = message('rcl_interfaces/msg/SetParametersResult', reason='because')
    link.reply(service, request.who, serialize(message('rcl_interfaces/srv/SetParameters_Response', results=[result])))
    link.flush()
    assert child.communicate(timeout=LONGEST_S)[0] == 'because\n'


def test_late_joiners_get_what_is_kept(link: RclpyLink, peer: Callable[[str], Any]) -> None:
    node = link.add_node('/', 'static')
    kept = QoS(depth=1, durability='transient_local')
    publisher = link.add(node, PUBLISHER, '/kept', interface('std_msgs/msg/String'), kept)
    link.publish(publisher, serialize(message('std_msgs/msg/String', data='once')))
    link.flush()
    child = peer("""
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String
heard = []
node.create_subscription(String, '/kept', heard.append, QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))
while not heard:
    rclpy.spin_once(node)
print(heard[0].data)
""")
    assert child.communicate(timeout=LONGEST_S)[0] == 'once\n'


def test_no_echo_of_what_we_said_ourselves(link: RclpyLink, peer: Callable[[str], Any]) -> None:
    kind = interface('std_msgs/msg/String')
    node = link.add_node('/', 'both')
    kept = QoS(depth=10, durability='transient_local')
    publisher = link.add(node, PUBLISHER, '/talk', kind, kept)
    link.publish(publisher, serialize(message('std_msgs/msg/String', data='before')))
    heard = link.add(node, SUBSCRIPTION, '/talk', kind, kept)
    peer("""
import time
from std_msgs.msg import String
publisher = node.create_publisher(String, '/talk', rclpy.qos.QoSProfile(depth=10, durability=rclpy.qos.DurabilityPolicy.TRANSIENT_LOCAL))
publisher.publish(String(data='of the peer'))
rclpy.spin(node)
""")
    for number in range(20):
        link.publish(publisher, serialize(message('std_msgs/msg/String', data=f'{number}')))
    came = of(Message, until(link, lambda events: of(Message, events)))
    for number in range(20, 40):
        link.publish(publisher, serialize(message('std_msgs/msg/String', data=f'{number}')))
    link.publish(link.add(node, PUBLISHER, '/end', kind, kept), serialize(message('std_msgs/msg/String', data='end')))
    probe = link.add(link.add_node('/', 'probe'), SUBSCRIPTION, '/rosout', interface('rcl_interfaces/msg/Log'), QoS())
    came += of(Message, until(link, lambda _: _end_of(link.graph(), 'publisher', '/talk')))
    texts = [deserialize(each.cdr, REGISTRY.get('std_msgs/msg/String')).data for each in came if each.handle != probe]
    assert (texts, {each.handle for each in came if each.handle != probe}) == (['of the peer'], {heard})


def test_what_rclpy_refuses_is_a_trouble_and_the_rest_goes_on(link: RclpyLink) -> None:
    node = link.add_node('/', 'odd')
    link.add(node, PUBLISHER, '/t', interface('std_msgs/msg/String'), QoS())
    link.add(node, SUBSCRIPTION, '/t', interface('std_msgs/msg/Int32'), QoS())
    diagnostic = of(LinkDiagnostic, until(link, lambda events: of(LinkDiagnostic, events)))[0]
    assert diagnostic.key == 'refused subscription /t'
    assert diagnostic.text.startswith('subscription /t: ')
    link.remove_node(link.add_node('/', 'fine'))
    link.flush()
    assert not of(LinkDiagnostic, list(link.take()))


def test_bytes_that_are_no_message_go_where_they_belong(link: RclpyLink, peer: Callable[[str], Any]) -> None:
    """A request that is no CDR of its type is told; what is asked next is served."""
    node = link.add_node('/', 'sim')
    client = link.add(node, CLIENT, '/sum', interface('example_interfaces/srv/AddTwoInts'), QoS())
    link.request(client, 1, b'\x00\x01\x00\x00\x01')
    assert of(LinkDiagnostic, until(link, lambda events: of(LinkDiagnostic, events)))[0].key == 'refused client /sum'


def test_images_without_guarantee_find_room_in_shared_memory(link: RclpyLink, peer: Callable[[str], Any]) -> None:
    """One megabyte at a time. With Fast DDS's usual segment of half a megabyte nearly all are lost. The next one goes when the last
    one came, or when it is lost: how fast this computer is decides nothing.
    """
    publisher = link.add(
        link.add_node('/', 'camera'), PUBLISHER, '/image', interface('std_msgs/msg/String'), QoS(reliability=BEST_EFFORT)
    )
    child = peer(
        'from rclpy.qos import qos_profile_sensor_data\nfrom std_msgs.msg import String\n'
        "node.create_subscription(String, '/image', lambda m: print('came', flush=True), qos_profile_sensor_data)\n"
        'rclpy.spin(node)\n'
    )
    assert child.stdout is not None
    output = child.stdout.fileno()
    until(link, lambda events: any(far.name == '/image' for far in link.graph().endpoints))
    cdr = serialize(message('std_msgs/msg/String', data='x' * 1_000_000))
    came = 0
    for _ in range(20):
        link.publish(publisher, cdr)
        lost_s = time.monotonic() + 2
        until(link, lambda events, lost_s=lost_s: select.select([output], [], [], 0)[0] or time.monotonic() >= lost_s)
        came += os.read(output, 4096).count(b'came') if select.select([output], [], [], 0)[0] else 0
    assert came >= 10


def test_a_side_process_that_dies_is_told_once(link: RclpyLink) -> None:
    child = link._child
    assert child is not None
    child.kill()
    diagnostic = of(LinkDiagnostic, until(link, lambda events: of(LinkDiagnostic, events)))
    assert [each.key for each in diagnostic] == ['died']
    node = link.add_node('/', 'late')
    link.flush()
    assert list(link.take()) == [] and node > 0
    link.close()
    link.close()


def test_without_the_real_rclpy_it_cannot_be_opened(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv(environment.PLACE_VARIABLE, str(tmp_path))
    with pytest.raises(LinkError, match='not installed'):
        RclpyLink().open(Settings())
