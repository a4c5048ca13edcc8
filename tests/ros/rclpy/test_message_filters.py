"""The filters of message_filters: what passes, in which groups, and what is dropped."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import message_filters
import pytest
import rclpy
from geometry_msgs.msg import PointStamped, TransformStamped
from hypothesis import given, settings
from hypothesis import strategies as st
from rclpy.node import Node
from rclpy.time import Time
from std_msgs.msg import String
from tf2_ros import Buffer

from .conftest import World

MS = 1_000_000


def point(stamp_ms: int, frame: str = 'laser') -> PointStamped:
    message = PointStamped()
    message.header.frame_id = frame
    message.header.stamp = Time(nanoseconds=stamp_ms * MS).to_msg()
    return message


def stamp_ms(message: Any) -> int:
    return int(message.header.stamp.sec * 1000 + message.header.stamp.nanosec // MS)


def paired(sync: Callable[..., Any], *arrivals: tuple[int, int]) -> list[tuple[int, ...]]:
    """Which stamps pass together when (topic, stamp) arrive in this order."""
    inputs = [message_filters.SimpleFilter(), message_filters.SimpleFilter()]
    groups: list[tuple[int, ...]] = []
    sync(inputs).registerCallback(lambda *messages: groups.append(tuple(map(stamp_ms, messages))))
    for topic, stamp in arrivals:
        inputs[topic].signalMessage(point(stamp))
    return groups


def test_a_subscriber_takes_the_arguments_of_a_subscription_and_a_depth_of_10(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('node')
        heard = message_filters.Subscriber(node, String, 'chatter')
        heard.registerCallback(lambda message, word: world.say((message.data, word)), 'extra')
        world.say((heard.getTopic(), heard.sub.qos_profile.depth, heard.topic_name))
        publisher = node.create_publisher(String, 'chatter', 10)
        publisher.publish(String(data='hi'))
        rclpy.spin_once(node)

    assert world.run_program(program) == [('chatter', 10, '/chatter'), ('hi', 'extra')]


def test_equal_stamps_pass_together_whatever_the_order() -> None:
    assert paired(lambda fs: message_filters.TimeSynchronizer(fs, 10), (0, 1), (0, 2), (1, 2), (1, 1)) == [(2, 2), (1, 1)]


def test_the_oldest_leaves_a_full_queue() -> None:
    assert paired(lambda fs: message_filters.TimeSynchronizer(fs, 1), (0, 1), (0, 2), (1, 1), (1, 2)) == [(2, 2)]


def test_near_stamps_pass_together_the_nearest_first() -> None:
    near = paired(
        lambda fs: message_filters.ApproximateTimeSynchronizer(fs, 10, 0.05), (0, 100), (0, 130), (1, 140), (1, 400), (0, 360)
    )
    assert near == [(130, 140), (360, 400)]


def test_a_difference_of_exactly_the_slop_is_too_much() -> None:
    assert paired(lambda fs: message_filters.ApproximateTimeSynchronizer(fs, 10, 0.05), (0, 100), (1, 150)) == []


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 1), st.integers(0, 40)), max_size=30), st.integers(1, 8))
def test_no_message_passes_twice_and_no_group_is_wider_than_the_slop(arrivals: list[tuple[int, int]], size: int) -> None:
    arrivals = list(dict.fromkeys(arrivals))
    groups = paired(lambda fs: message_filters.ApproximateTimeSynchronizer(fs, size, 0.005), *arrivals)
    assert all(abs(first - second) < 5 for first, second in groups)
    for topic in (0, 1):
        passed = [group[topic] for group in groups]
        assert len(set(passed)) == len(passed) <= sum(of == topic for of, _ in arrivals)


def test_headerless_messages_are_dropped_with_a_warning_unless_allowed(world: World) -> None:
    def program() -> None:
        rclpy.init()
        for allow in (False, True):
            entry = message_filters.SimpleFilter()
            cache = message_filters.Cache(entry, 3, allow_headerless=allow)
            entry.signalMessage(String(data='x'))
            world.say([message.data for message in cache.cache_msgs])

    assert world.run_program(program) == [[], ['x']]
    assert 'without timestamp infomation when "allow_headerless" is disabled' in world.output['main']


def test_a_cache_answers_by_time_and_forgets_the_oldest() -> None:
    cache = message_filters.Cache(cache_size=3)
    assert (cache.getLast(), cache.getLastestTime(), cache.getOldestTime()) == (None, None, None)
    passed: list[int] = []
    cache.registerCallback(lambda message: passed.append(stamp_ms(message)))
    for stamp in (10, 20, 30, 40):
        cache.add(point(stamp))
    assert passed == [10, 20, 30, 40]

    def at(ms: int) -> Time:
        return Time.from_msg(point(ms).header.stamp)

    assert [stamp_ms(message) for message in cache.getInterval(at(20), at(30))] == [20, 30]
    assert stamp_ms(cache.getElemAfterTime(at(31))) == 40
    assert stamp_ms(cache.getElemBeforeTime(at(29))) == 20
    assert stamp_ms(cache.getElemBeforeTime(at(30))) == stamp_ms(cache.getElemAfterTime(at(30))) == 30
    assert cache.getElemBeforeTime(at(19)) is None
    assert (cache.getOldestTime(), cache.getLatestTime(), stamp_ms(cache.getLast())) == (at(20), at(40), 40)


def test_a_message_filter_waits_for_tf_and_says_what_it_drops(world: World) -> None:
    def program() -> None:
        rclpy.init()
        buffer = Buffer()
        entry = message_filters.SimpleFilter()
        ready = message_filters.MessageFilter(buffer, 'map', 2, Node('node'), entry)
        ready.registerCallback(lambda message: world.say(('passed', stamp_ms(message))))
        ready.registerFailureCallback(lambda message, reason: world.say((reason.name, stamp_ms(message))))
        for stamp in (1000, 1200, 1300):
            entry.signalMessage(point(stamp))
        entry.signalMessage(point(5, frame=''))
        for stamp in (1100, 1250):
            transform = TransformStamped(header=point(stamp, 'map').header, child_frame_id='laser')
            buffer.set_transform(transform, 'test')
        entry.signalMessage(point(900))

    assert world.run_program(program) == [('QueueFull', 1000), ('EmptyFrameID', 5), ('passed', 1200), ('OutTheBack', 900)]
    assert (
        "Message Filter dropping message: frame 'laser' at time 1.000 for reason 'discarding message because the queue is full'"
    ) in world.output['main']


def test_a_filter_can_wait_for_several_frames_and_a_tolerance(world: World) -> None:
    def program() -> None:
        rclpy.init()
        buffer = Buffer()
        ready = message_filters.MessageFilter(buffer, ['map', 'odom'], 0, Node('node'))
        ready.setTolerance(rclpy.duration.Duration(nanoseconds=100 * MS))
        ready.registerCallback(lambda message: world.say(stamp_ms(message)))
        ready.add(point(1000))
        for stamp, parent, child in (
            (1000, 'odom', 'laser'),
            (1000, 'map', 'odom'),
            (1100, 'map', 'odom'),
            (1100, 'odom', 'laser'),
        ):
            buffer.set_transform(TransformStamped(header=point(stamp, parent).header, child_frame_id=child), 'test')
            world.say((parent, stamp))

    assert world.run_program(program) == [('odom', 1000), ('map', 1000), ('map', 1100), 1000, ('odom', 1100)]


def test_an_interval_that_ends_before_it_begins_is_refused() -> None:
    with pytest.raises(AssertionError):
        message_filters.Cache().getInterval(Time(nanoseconds=2), Time(nanoseconds=1))
