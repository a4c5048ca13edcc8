"""Questions of a node about the graph: who is there, what they offer, of which type it is."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
from rclpy._rclpy_pybind11 import NodeNameNonExistentError, RCLError
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Empty

from edulaunch.engine.sim.sync import sleep

from .conftest import Ros, World


def test_the_graph_can_be_asked(ros: Ros, world: World) -> None:
    def body() -> None:
        node, other = Node('n'), Node('other', namespace='/ns')
        other.create_publisher(String, 'chatter', 7)
        node.create_subscription(String, '/ns/chatter', lambda _: None, 10)
        other.create_client(Empty, '/clear')
        world.say(
            (
                node.get_node_names(),
                node.get_node_names_and_namespaces(),
                node.count_publishers('/ns/chatter'),
                node.count_subscribers('/ns/chatter'),
                node.count_clients('/clear'),
                node.count_services('/clear'),
            )
        )
        world.say([pair for pair in node.get_topic_names_and_types() if 'chatter' in pair[0]])
        world.say(node.get_publisher_names_and_types_by_node('other', '/ns')[0])
        world.say(node.get_client_names_and_types_by_node('other', '/ns'))
        info = node.get_publishers_info_by_topic('/ns/chatter')[0]
        world.say((info.node_name, info.node_namespace, info.topic_type, info.endpoint_type.name, info.qos_profile.depth))
        world.say(str(info).splitlines()[4:])
        with pytest.raises(NodeNameNonExistentError):
            node.get_service_names_and_types_by_node('nobody', '/')

    assert ros(body) == [
        (['n', 'other'], [('n', '/'), ('other', '/ns')], 1, 1, 1, 0),
        [('/ns/chatter', ['std_msgs/msg/String'])],
        ('/ns/chatter', ['std_msgs/msg/String']),
        [('/clear', ['std_srvs/srv/Empty'])],
        ('other', '/ns', 'std_msgs/msg/String', 'PUBLISHER', 0),
        [
            'Endpoint type: PUBLISHER',
            f'GID: {"00." * 15}{_gid(world)}',
            'QoS profile:',
            '  Reliability: RELIABLE',
            '  History (Depth): UNKNOWN',
            '  Durability: VOLATILE',
            '  Lifespan: Infinite',
            '  Deadline: Infinite',
            '  Liveliness: AUTOMATIC',
            '  Liveliness lease duration: Infinite',
        ],
    ]


def _gid(world: World) -> str:
    shown = next(what for _, _, what in world.log if isinstance(what, list) and str(what[0]).startswith('Endpoint'))
    return str(shown[1])[-2:]


def test_waiting_for_a_node(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        world.say((node.wait_for_node('/late', timeout=0.5), node.wait_for_node('/late', timeout=0.7)))

    world.start(program)
    world.start(lambda: (sleep(1.05), rclpy.init(), Node('late'), sleep(5)), name='late')
    assert world.run(2) == [(1200.0, 'main', (False, True))]


def test_a_destroyed_node_leaves_the_graph(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.create_timer(0.1, lambda: world.say('tick'))
        node.destroy_node()
        node.destroy_node()
        world.say(([entry.name for entry in world.graph.nodes], world.graph.publishers, world.graph.services))

    assert ros(body) == [([], {}, {})]


def test_a_program_that_ends_takes_its_nodes_along(world: World) -> None:
    world.start(lambda: (rclpy.init(), Node('n')))
    world.run(1)
    assert world.graph.nodes == []


def test_others_can_ask_what_a_type_looks_like(ros: Ros, world: World) -> None:
    from type_description_interfaces.srv import GetTypeDescription

    def body() -> None:
        node = Node('n')
        node.create_publisher(String, 'c', 10)
        client = node.create_client(GetTypeDescription, 'n/get_type_description')
        right_hash = str(node.get_publishers_info_by_topic('c')[0].topic_type_hash)
        for name, asked_hash in (
            ('std_msgs/msg/String', right_hash),
            ('std_msgs/msg/Bool', right_hash),
            ('std_msgs/msg/String', f'RIHS01_{0:064}'),
            ('std_msgs/msg/String', ''),
        ):
            request = GetTypeDescription.Request(type_name=name, type_hash=asked_hash, include_type_sources=True)
            future = client.call_async(request)
            rclpy.spin_until_future_complete(node, future)
            answer = future.result()
            fields = [field.name for field in answer.type_description.type_description.fields]
            world.say(answer.failure_reason or (fields, [(one.type_name, one.encoding) for one in answer.type_sources]))

    assert ros(body) == [
        (['data'], [('std_msgs/msg/String', 'msg')]),
        (['data'], [('std_msgs/msg/String', 'msg')]),  # rcl looks for the hash alone
        'Type not currently in use by this node',
        'Failed to parse type hash',
    ]


@pytest.mark.parametrize(
    'look',
    [
        lambda node, publisher: node.count_subscribers('chatter'),
        lambda node, publisher: publisher.get_subscription_count(),
        lambda node, publisher: 'late' in node.get_node_names(),
        lambda node, publisher: any(name == '/late/get_parameters' for name, _ in node.get_service_names_and_types()),
    ],
)
def test_a_loop_that_only_looks_at_the_graph_lets_the_world_go_on(world: World, look: Any) -> None:
    def waiting() -> None:
        rclpy.init()
        node = Node('waiting')
        publisher = node.create_publisher(String, 'chatter', 10)
        while not look(node, publisher):
            pass
        world.say('there')

    def late() -> None:
        sleep(0.5)
        rclpy.init()
        node = Node('late')
        node.create_subscription(String, 'chatter', world.say, 10)
        rclpy.spin(node)

    world.start(waiting)
    world.start(late, name='late')
    ((at, _, what),) = world.run(2)
    assert (at // 10, what) == (50, 'there')


@pytest.mark.parametrize(
    ('name', 'namespace', 'text'),
    [
        ('m', '/', 'cannot get publisher names and types for nonexistent node: error not set'),
        ('n', 'ns', "failed to get publisher names and types: namespace must be absolute, it must lead with a '/', result: 2"),
        ('', '/', 'failed to get publisher names and types: node name must not be empty, result: 1'),
        ('1', '/', 'failed to get publisher names and types: node name must not start with a number, result: 2'),
    ],
)
def test_asking_about_a_node_needs_its_full_namespace(ros: Ros, world: World, name: str, namespace: str, text: str) -> None:
    def body() -> None:
        with pytest.raises(RCLError) as caught:
            Node('n', namespace='ns').get_publisher_names_and_types_by_node(name, namespace)
        world.say(str(caught.value))

    assert ros(body) == [text]


def test_waiting_for_a_node_takes_names_without_their_slash_and_needs_time(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', namespace='ns')
        world.say([node.wait_for_node('ns/n', 0.05), node.wait_for_node('n', 0.1), node.wait_for_node('/ns/n', 0.0)])

    assert ros(body) == [[True, False, False]]


def test_the_graph_cannot_be_asked_after_shutdown(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        rclpy.shutdown()
        for ask, text in (
            (node.get_node_names, 'Failed to get node names'),
            (node.get_topic_names_and_types, 'failed to get topic names and types'),
            (lambda: node.count_subscribers('a'), 'Error in rcl_count_subscribers'),
            (lambda: node.get_publishers_info_by_topic('a'), 'Failed to get information by topic for publishers'),
            (lambda: node.get_client_names_and_types_by_node('n', '/'), 'failed to get client names and types'),
        ):
            with pytest.raises(RCLError, match=f"^{text}: rcl node's context is invalid$"):
                ask()
        world.say('asked')

    assert ros(body) == ['asked']


def test_queries_name_what_is_wrong_with_a_name(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        with pytest.raises(ValueError, match="^topic name '' is invalid: topic name must not be empty string$"):
            node.count_services('')
        with pytest.raises(ValueError, match="^topic name 'a b' is invalid: topic name must not contain characters other than"):
            node.get_publishers_info_by_topic('a b')
        world.say('asked')

    assert ros(body) == ['asked']


def test_others_do_not_know_the_history_of_an_endpoint(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.create_publisher(String, 'chatter', 7)
        (info,) = node.get_publishers_info_by_topic('chatter')
        world.say((info.qos_profile.history.name, info.qos_profile.depth, '  History (Depth): UNKNOWN' in str(info).splitlines()))

    assert ros(body) == [('UNKNOWN', 0, True)]


def test_names_that_are_not_demangled_are_those_of_dds(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', enable_rosout=False, start_parameter_services=False)
        node.create_publisher(String, 'chatter', 10)
        node.create_subscription(String, 'heard', print, 10)
        names = dict(node.get_topic_names_and_types(no_demangle=True))
        world.say(names['rt/chatter'])
        world.say(names['rq/n/get_type_descriptionRequest'])
        world.say(next(iter(names)))
        world.say(sorted(dict(node.get_publisher_names_and_types_by_node('n', '/', no_demangle=True))))
        world.say(node.get_subscriber_names_and_types_by_node('n', '/', no_demangle=True)[1])

    assert ros(body) == [
        ['std_msgs::msg::dds_::String_'],
        ['type_description_interfaces::srv::dds_::GetTypeDescription_Request_'],
        'ros_discovery_info',
        ['rr/n/get_type_descriptionReply', 'rt/chatter', 'rt/parameter_events'],
        ('rt/heard', ['std_msgs::msg::dds_::String_']),
    ]
