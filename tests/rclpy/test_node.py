"""rclpy.node: names, remapping, the graph, its end."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
import rclpy
from rclpy import wait_for_message as waiting
from rclpy._rclpy_pybind11 import NodeNameNonExistentError, RCLError
from rclpy.exceptions import (
    InvalidHandle,
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
)
from rclpy.expand_topic_name import expand_topic_name
from rclpy.node import Node
from rclpy.qos import QoSPolicyKind, QoSProfile
from rclpy.qos_overriding_options import InvalidQosOverridesError, QoSOverridingOptions
from std_msgs.msg import String
from std_srvs.srv import Empty

from edulaunch.facts import facts_of
from edulaunch.sim.sync import sleep

from .conftest import World

Ros = Callable[..., list[Any]]


def test_entities_of_a_new_node_are_made_in_the_order_of_rclpy(ros: Ros, world: World) -> None:
    def body() -> None:
        entry = Node('n', enable_logger_service=True).handle
        world.say([(end.kind, getattr(end, 'topic_name', None) or end.service_name) for end in entry.endpoints])

    assert ros(body) == [
        [('publisher', '/rosout'), ('publisher', '/parameter_events')]
        + [
            ('service', f'/n/{name}')
            for name in (
                'describe_parameters',
                'get_parameters',
                'get_parameter_types',
                'list_parameters',
                'set_parameters',
                'set_parameters_atomically',
                'get_logger_levels',
                'set_logger_levels',
                'get_type_description',
            )
        ]
    ]


@pytest.mark.parametrize(
    ('names', 'error', 'text'),
    [
        (
            ('my node',),
            InvalidNodeNameException,
            "Invalid node name: node name must not contain characters other than alphanumerics or '_':\n  'my node'\n     ^",
        ),
        (
            ('n', 'a b'),
            InvalidNamespaceException,
            "Invalid namespace: namespace must not contain characters other than alphanumerics, '_', or '/':\n  '/a b'\n     ^",
        ),
    ],
)
def test_bad_names_are_shown_with_a_caret(ros: Ros, world: World, names: Any, error: Any, text: str) -> None:
    def body() -> None:
        with pytest.raises(error) as caught:
            Node(names[0], namespace=names[-1] if len(names) > 1 else None)
        world.say(str(caught.value))

    assert ros(body) == [text]


def test_a_refused_name_is_no_value_error(ros: Ros) -> None:
    def body() -> None:
        with pytest.raises(InvalidNodeNameException, match='Invalid node name') as caught:
            Node('1st')
        assert not isinstance(caught.value, ValueError)

    ros(body)


def test_bad_topics_and_services_have_exceptions_of_their_own(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        with pytest.raises(InvalidTopicNameException, match='topic name must not contain repeated'):
            node.create_publisher(String, 'a//b', 10)
        with pytest.raises(
            InvalidServiceNameException, match='Invalid service name: topic name must not end with a forward slash'
        ):
            node.create_client(Empty, 'a/')
        world.say('refused')

    assert ros(body) == ['refused']


def test_remap_rules_change_nodes_topics_and_services(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        world.say(
            (
                node.get_fully_qualified_name(),
                node.get_logger().name,
                node.resolve_topic_name('chatter'),
                node.resolve_service_name('chatter'),
                node.resolve_topic_name('~/x'),
                node.resolve_topic_name('chatter', only_expand=True),
            )
        )

    rules = ('__node:=renamed', '__ns:=/deep/er', 'rostopic://chatter:=/talk', 'chatter:=other')
    assert ros(body, '--ros-args', *(part for rule in rules for part in ('-r', rule))) == [
        ('/deep/er/renamed', 'deep.er.renamed', '/talk', '/deep/er/other', '/deep/er/renamed/x', '/deep/er/chatter')
    ]


def test_arguments_of_the_node_come_before_those_of_the_program(ros: Ros, world: World) -> None:
    def body() -> None:
        own = Node('n', cli_args=['--ros-args', '-r', 'a:=own', '-p', 'p:=1'])
        apart = Node('m', use_global_arguments=False)
        world.say(
            (
                own.resolve_topic_name('a'),
                own.declare_parameter('p', 0).value,
                own.declare_parameter('q', 0).value,
                apart.resolve_topic_name('a'),
            )
        )

    assert ros(body, '--ros-args', '-r', 'a:=global', '-p', 'p:=2', '-p', 'q:=2') == [('/own', 1, 2, '/a')]


def test_a_rename_of_the_program_renames_all_its_nodes(ros: Ros, world: World) -> None:
    ros(lambda: world.say([Node('a').get_name(), Node('b').get_name()]), '--ros-args', '-r', '__node:=same')
    assert [what for _, _, what in world.log] == [['same', 'same']]


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


def test_a_forgotten_super_init_is_explained(ros: Ros, world: World) -> None:
    class Forgetful(Node):
        def __init__(self) -> None:
            self.publisher = self.create_publisher(String, 'c', 10)

    def body() -> None:
        with pytest.raises(AttributeError, match="'Forgetful' object has no attribute '_default_callback_group'") as caught:
            Forgetful()
        world.say(facts_of(caught.value)['about'])

    assert ros(body) == ['programs.no-super-init']


def test_one_message_can_be_waited_for_without_spinning(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        world.say(waiting.wait_for_message(String, node, 'c', time_to_wait=0.1))
        found, message = waiting.wait_for_message(String, node, 'c')
        world.say((found, message.data))

    def speaking() -> None:
        rclpy.init()
        publisher = Node('talker').create_publisher(String, 'c', 10)
        sleep(0.3)
        publisher.publish(String(data='x'))

    world.start(program)
    world.start(speaking, name='talker')
    assert world.run(1) == [(100.0, 'main', (False, None)), (300.0, 'main', (True, 'x'))]


def test_parameters_may_override_quality_of_service(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        options = QoSOverridingOptions((QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY))
        publisher = node.create_publisher(String, 'c', QoSProfile(depth=10), qos_overriding_options=options)
        world.say((publisher.qos_profile.depth, node.get_parameter('qos_overrides./c.publisher.reliability').value))

    assert ros(body, '--ros-args', '-p', 'qos_overrides./c.publisher.depth:=3') == [(3, 'reliable')]


def test_quality_of_service_overrides_may_be_refused(ros: Ros, world: World) -> None:
    from rcl_interfaces.msg import SetParametersResult

    def body() -> None:
        options = QoSOverridingOptions.with_default_policies(callback=lambda profile: SetParametersResult(reason='no'))
        with pytest.raises(
            InvalidQosOverridesError, match='^Provided QoS overrides for publisher `/c` with id `None`, are not valid: no$'
        ):
            Node('n').create_publisher(String, 'c', 10, qos_overriding_options=options)
        world.say('refused')

    assert ros(body) == ['refused']


@pytest.mark.parametrize(
    ('value', 'what'),
    [
        ('best_effort', 'reliability for publisher `/c` with id `left`'),
        ('wrong', 'Unexpected QoS override for policy `reliability`: `wrong`'),
    ],
)
def test_an_override_is_described_by_its_endpoint_and_must_name_a_value(ros: Ros, world: World, value: str, what: str) -> None:
    def body() -> None:
        node, options = Node('n'), QoSOverridingOptions([QoSPolicyKind.RELIABILITY], entity_id='left')
        try:
            node.create_publisher(String, 'c', 10, qos_overriding_options=options)
            world.say(node.describe_parameter('qos_overrides./c.publisher_left.reliability').description)
        except RuntimeError as error:
            world.say(str(error))

    assert ros(body, '--ros-args', '-p', f'qos_overrides./c.publisher_left.reliability:={value}') == [what]


def test_a_subscription_has_no_lifespan_to_override(ros: Ros, world: World) -> None:
    def body() -> None:
        node, options = Node('n'), QoSOverridingOptions([QoSPolicyKind.LIFESPAN, QoSPolicyKind.DEADLINE])
        node.create_subscription(String, 'c', print, 10, qos_overriding_options=options)
        world.say(sorted(name for name in node.get_parameters_by_prefix('qos_overrides./c')))

    assert ros(body) == [['subscription.deadline']]


def test_waiting_for_a_message_of_a_context_that_is_down_is_an_error(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        with pytest.raises(AttributeError, match="^type object 'int' has no attribute '_TYPE_SUPPORT'"):
            waiting.wait_for_message(3, node, 'c')
        rclpy.shutdown()
        with pytest.raises(RCLError, match='^failed to initialize wait set: the given context is not valid'):
            waiting.wait_for_message(String, node, 'c', time_to_wait=0.1)
        world.say('refused')

    assert ros(body) == ['refused']


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
        'Type not currently in use by this node',
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


def test_a_destroyed_node_makes_nothing_and_has_no_name_any_more(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.destroy_node()
        for use in (node.get_name, node.get_topic_names_and_types, lambda: node.create_publisher(String, 't', 1)):
            with pytest.raises(InvalidHandle, match='cannot use Destroyable because destruction was requested'):
                use()
        world.say(node.get_logger().info('still there'))

    assert ros(body) == [True]


@pytest.mark.parametrize(
    'make',
    [lambda node: Node(None), lambda node: node.create_publisher(String, 3, 1), lambda node: node.create_client(Empty, None)],
)
def test_a_name_that_is_no_text_is_a_type_error(ros: Ros, world: World, make: Callable[[Node], Any]) -> None:
    def body() -> None:
        with pytest.raises(TypeError, match='a name must be a str, not (int|NoneType)'):
            make(Node('n'))

    ros(body)


@pytest.mark.parametrize(
    ('names', 'what'), [(('a?', 'n', '/'), 'topic name'), (('a', 'n?', '/'), 'node name'), (('a', 'n', '/?'), 'node namespace')]
)
def test_expanding_needs_legal_names(names: tuple[str, str, str], what: str) -> None:
    with pytest.raises(ValueError, match=rf"{what} '.+\?' is invalid: "):
        expand_topic_name(*names)


def test_a_bad_name_that_is_only_resolved_is_an_rcl_error(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        for name in ('a b', 'a//b', '{nod}'):
            with pytest.raises(RCLError) as caught:
                node.resolve_service_name(name)
            world.say(str(caught.value))

    assert ros(body) == [
        "failed to resolve name: topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'",
        "failed to resolve name: topic name must not contain repeated '/'",
        'failed to resolve name: unknown substitution: {nod}',
    ]


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
