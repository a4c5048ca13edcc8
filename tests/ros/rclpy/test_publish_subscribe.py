"""Publishers and subscriptions of rclpy nodes."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import pytest
import rclpy
from geometry_msgs.msg import Twist
from rclpy._rclpy_pybind11 import InvalidHandle, RCLError, RMWError
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from rclpy.serialization import deserialize_message, serialize_message
from std_msgs.msg import Bool, String
from std_srvs.srv import Empty

from edulaunch.engine.sim.sync import sleep

from .conftest import Ros, World


def listener(world: World, name: str = 'listener', **options: Any) -> Callable[[], None]:
    def program() -> None:
        rclpy.init()
        node = Node(name)
        node.create_subscription(String, 'chatter', lambda message: world.say(message.data), options.get('qos', 10))
        rclpy.spin(node)

    return program


def talker(*texts: str, qos: Any = 10, wait_s: float = 0.1) -> Callable[[], None]:
    def program() -> None:
        rclpy.init()
        node = Node('talker')
        publisher = node.create_publisher(String, 'chatter', qos)
        for text in texts:
            if wait_s:
                sleep(wait_s)
            publisher.publish(String(data=text))

    return program


def test_messages_cross_programs_at_the_time_of_publishing(world: World) -> None:
    world.start(listener(world), name='listener')
    world.start(talker('a', 'b'), name='talker')
    assert world.run(1) == [(100.0, 'listener', 'a'), (200.0, 'listener', 'b')]


def test_subscriptions_hear_in_order_of_creation(world: World) -> None:
    for name in ('first', 'second'):
        world.start(listener(world, name), name=name)
    world.start(talker('a'), name='talker')
    assert [who for _, who, _ in world.run(1)] == ['first', 'second']


def test_a_message_is_copied_when_it_is_published(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        message = String(data='before')
        node.create_subscription(String, 'chatter', lambda heard: world.say((heard.data, heard is message)), 10)
        node.create_publisher(String, 'chatter', 10).publish(message)
        message.data = 'after'
        rclpy.spin_once(node)

    assert world.run_program(program) == [('before', False)]


def test_a_full_queue_drops_the_oldest(world: World) -> None:
    world.start(listener(world, qos=2), name='listener')
    world.start(talker('a', 'b', 'c', wait_s=0), name='talker')
    assert [what for _, _, what in world.run(1)] == ['b', 'c']


def test_another_message_class_is_refused(ros: Ros, world: World) -> None:
    def body() -> None:
        with pytest.raises(TypeError) as caught:
            Node('n').create_publisher(Twist, 'cmd_vel', 10).publish(String())
        world.say(str(caught.value))

    assert ros(body) == ["Expected <class 'geometry_msgs.msg._twist.Twist'>, got <class 'std_msgs.msg._string.String'>"]


def test_publishing_after_shutdown_is_refused(ros: Ros, world: World) -> None:
    def body() -> None:
        publisher = Node('n').create_publisher(String, 'chatter', 10)
        rclpy.shutdown()
        with pytest.raises(RCLError, match="Failed to publish: publisher's context is invalid"):
            publisher.publish(String())
        world.say('refused')

    assert ros(body) == ['refused']


def test_a_destroyed_publisher_cannot_publish(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        publisher = node.create_publisher(String, 'chatter', 10)
        assert node.destroy_publisher(publisher)
        with pytest.raises(InvalidHandle):
            publisher.publish(String())
        world.say(node.destroy_publisher(publisher))

    assert ros(body) == [False]


@pytest.mark.parametrize(
    ('msg_type', 'error', 'text'),
    [
        (
            Empty,
            RuntimeError,
            "The message type provided is not valid (<class 'std_srvs.srv._empty.Empty'>), this might be a service or action",
        ),
        *(
            (
                wrong,
                AttributeError,
                f"type object '{named}' has no attribute '_TYPE_SUPPORT' This might be a ROS 1 message type but it should "
                'be a ROS 2 message type. Make sure to source your ROS 2 workspace after your ROS 1 workspace.',
            )
            for wrong, named in ((str, 'type'), ('chatter', 'str'), (rclpy, 'module'))
        ),
    ],
)
def test_wrong_type_objects_are_explained(ros: Ros, world: World, msg_type: Any, error: type[Exception], text: str) -> None:
    def body() -> None:
        with pytest.raises(error) as caught:
            Node('n').create_publisher(msg_type, 'chatter', 10)
        world.say(str(caught.value))
        with pytest.raises(TypeError, match='incompatible function arguments'):  # the name is resolved first
            Node('n').create_publisher(msg_type, Empty, 10)  # type: ignore[arg-type]

    assert ros(body) == [text]


def test_a_callback_may_take_the_message_info(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.create_subscription(String, 'c', lambda message, info: world.say(sorted(info)), 10)
        node.create_publisher(String, 'c', 10).publish(String())
        rclpy.spin_once(node)

    assert ros(body) == [['publication_sequence_number', 'received_timestamp', 'reception_sequence_number', 'source_timestamp']]


def test_each_publisher_numbers_its_messages(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        first, second = (node.create_publisher(String, 'c', 10) for _ in range(2))
        first.publish(String(data='nobody hears this'))
        node.create_subscription(String, 'c', lambda message, info: world.say(info['publication_sequence_number']), 10)
        for publisher in (first, second, first):
            publisher.publish(String())
            rclpy.spin_once(node)

    assert ros(body) == [2, 1, 3]


@pytest.mark.parametrize(
    ('callback', 'count'),
    [
        (lambda message: None, 'MessageOnly'),
        (lambda *messages: None, 'MessageOnly'),
        (print, 'MessageOnly'),
        (lambda message, info: None, 'WithMessageInfo'),
        (partial(lambda extra, message: None, 1), 'MessageOnly'),
        (lambda message, other=1: None, 'MessageOnly'),
    ],
)
def test_what_a_callback_takes_is_found_out(callback: Any, count: str) -> None:
    from rclpy.subscription import callback_type

    assert callback_type(callback).name == count


@pytest.mark.parametrize('callback', [lambda: None, lambda a, b, c: None])
def test_other_callbacks_are_refused(callback: Any) -> None:
    from rclpy.subscription import callback_type

    with pytest.raises(RuntimeError, match='callback should be either be callable with one argument'):
        callback_type(callback)


def test_late_subscriptions_get_transient_local_samples(world: World) -> None:
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)

    def program() -> None:
        rclpy.init()
        node = Node('n')
        node.create_publisher(String, 'chatter', latched).publish(String(data='kept'))
        node.create_subscription(String, 'chatter', lambda message: world.say(('late', message.data)), latched)
        node.create_subscription(String, 'chatter', lambda message: world.say('volatile'), 10)
        rclpy.spin_once(node, timeout_sec=0.1)

    assert world.run_program(program) == [('late', 'kept')]


def test_incompatible_quality_of_service_is_warned_of_on_both_sides(world: World) -> None:
    def speaking() -> None:
        rclpy.init()
        node = Node('talker')
        node.create_publisher(String, 'chatter', qos_profile_sensor_data)
        rclpy.spin(node)

    world.start(listener(world), name='listener')
    world.start(speaking, name='talker')
    world.run(1)
    assert sorted(world.tracer.logs) == [
        (
            30,
            'listener',
            "New publisher discovered on topic 'chatter', offering incompatible QoS. No messages will be received "
            'from it. Last incompatible policy: RELIABILITY',
        ),
        (
            30,
            'talker',
            "New subscription discovered on topic 'chatter', requesting incompatible QoS. No messages will be sent "
            'to it. Last incompatible policy: RELIABILITY',
        ),
    ]


def test_matched_events_count(ros: Ros, world: World) -> None:
    from rclpy.event_handler import PublisherEventCallbacks

    def body() -> None:
        node = Node('n')
        node.create_publisher(String, 'c', 10, event_callbacks=PublisherEventCallbacks(matched=world.say))
        node.create_subscription(String, 'c', lambda _: None, 10)
        rclpy.spin_once(node, timeout_sec=0.1)

    assert [info.current_count for info in ros(body)] == [1]


def test_raw_subscriptions_and_serialized_publishing(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.create_subscription(String, 'c', lambda data: world.say(deserialize_message(data, String).data), 10, raw=True)
        node.create_publisher(String, 'c', 10).publish(serialize_message(String(data='bytes')))
        rclpy.spin_once(node)

    assert ros(body) == ['bytes']


def test_counts_and_names(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', namespace='ns')
        publisher = node.create_publisher(String, 'c', 10)
        subscription = node.create_subscription(String, '/ns/c', lambda _: None, 10)
        world.say((publisher.topic_name, publisher.get_subscription_count(), subscription.get_publisher_count()))

    assert ros(body) == [('/ns/c', 1, 1)]


def test_a_subscription_destroyed_in_a_callback_is_silent_at_once(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        second: list[Any] = []
        node.create_subscription(String, 'c', lambda _: node.destroy_subscription(second[0]), 10)
        second.append(node.create_subscription(String, 'c', lambda _: world.say('heard'), 10))
        node.create_publisher(String, 'c', 10).publish(String())
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        executor.spin_once(timeout_sec=0.1)
        executor.spin_once(timeout_sec=0.1)

    assert ros(body) == []


def test_best_effort_publishers_reach_best_effort_subscriptions(world: World) -> None:
    profile = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
    world.start(listener(world, qos=profile), name='listener')
    world.start(talker('a', qos=profile), name='talker')
    assert [what for _, _, what in world.run(1)] == ['a']


def test_serialized_messages_of_one_size_fill_multiples_of_four_bytes() -> None:
    assert [len(serialize_message(message)) for message in (Bool(), Twist(), String(data='abcd'))] == [8, 52, 13]
    assert deserialize_message(serialize_message(Bool(data=True)), Bool).data is True


def test_bytes_of_another_type_are_refused_in_the_words_of_fast_dds() -> None:
    with pytest.raises(RMWError) as caught:
        deserialize_message(b'abcd', String)
    assert str(caught.value) == (
        'failed to deserialize ROS message: Fast CDR exception deserializing message of type std_msgs::msg::dds_::String_.'
    )
    with pytest.raises(TypeError, match='incompatible function arguments'):
        deserialize_message('text', String)


def test_waiting_for_acknowledgements_takes_a_duration(ros: Ros, world: World) -> None:
    def body() -> None:
        publisher = Node('n').create_publisher(String, 't', 1)
        world.say((publisher.wait_for_all_acked(), publisher.wait_for_all_acked(Duration(seconds=1))))
        with pytest.raises(AttributeError, match="^'float' object has no attribute '_duration_handle'$"):
            publisher.wait_for_all_acked(1.0)

    assert ros(body) == [(True, True)]
