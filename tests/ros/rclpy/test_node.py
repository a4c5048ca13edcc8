"""rclpy.node: names, remapping, what a node makes, its end."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from rclpy._rclpy_pybind11 import RCLError
from rclpy.exceptions import (
    InvalidHandle,
    InvalidNamespaceException,
    InvalidNodeNameException,
    InvalidServiceNameException,
    InvalidTopicNameException,
)
from rclpy.expand_topic_name import expand_topic_name
from rclpy.node import HIDDEN_NODE_PREFIX, Node
from std_msgs.msg import String
from std_srvs.srv import Empty

from edulaunch.engine.facts import facts_of

from .conftest import Ros, World


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


def test_a_forgotten_super_init_is_explained(ros: Ros, world: World) -> None:
    class Forgetful(Node):
        def __init__(self) -> None:
            self.publisher = self.create_publisher(String, 'c', 10)

    def body() -> None:
        with pytest.raises(AttributeError, match="'Forgetful' object has no attribute '_default_callback_group'") as caught:
            Forgetful()
        world.say(facts_of(caught.value)['about'])

    assert ros(body) == ['programs.no-super-init']


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


def test_a_node_with_the_hidden_prefix_is_in_the_graph(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node(f'{HIDDEN_NODE_PREFIX}probe')
        world.say([name for name in node.get_node_names() if name.startswith('_')])

    assert ros(body) == [['_probe']]
