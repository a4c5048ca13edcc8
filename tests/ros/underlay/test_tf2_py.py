"""tf2_py: messages in and out, exceptions, argument types."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
import tf2_py
from builtin_interfaces.msg import Duration as DurationMessage
from builtin_interfaces.msg import Time as TimeMessage
from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_py import BufferCore

SECOND = 1_000_000_000


def stamped(parent: str, child: str, seconds: int, x: float) -> TransformStamped:
    return TransformStamped.from_wire((seconds, 0, parent, child, x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))


@pytest.fixture
def buffer() -> BufferCore:
    core = BufferCore()
    for seconds in (5, 6):
        core.set_transform(stamped('world', 'turtle1', seconds, float(seconds)), 'default_authority')
    return core


def test_a_lookup_gives_a_message_with_both_frames_and_the_stamp(buffer):
    found = buffer.lookup_transform_core('world', 'turtle1', Time())
    assert (found.header.frame_id, found.child_frame_id) == ('world', 'turtle1')
    assert (found.header.stamp.sec, found.header.stamp.nanosec) == (6, 0)
    assert found.transform.translation.x == 6.0


@pytest.mark.parametrize(
    'time',
    [
        Time(seconds=5.5),
        TimeMessage(sec=5, nanosec=500_000_000),
        Duration(seconds=5.5),
        DurationMessage(sec=5, nanosec=500_000_000),
    ],
)
def test_times_may_be_of_any_kind(buffer, time):
    assert buffer.lookup_transform_core('world', 'turtle1', time).transform.translation.x == 5.5


@pytest.mark.parametrize('time', [5.5, 5, None, 'now'])
def test_plain_numbers_are_no_times(buffer, time):
    with pytest.raises(TypeError, match=r'^time must have sec and nanosec, or nanoseconds\.$'):
        buffer.lookup_transform_core('world', 'turtle1', time)


def test_the_cache_length_is_a_duration():
    core = BufferCore(Duration(seconds=2.0))
    for seconds in (1, 2, 3, 4, 5):
        core.set_transform(stamped('world', 'a', seconds, 0.0), 'me')
    assert core.can_transform_core('world', 'a', Time(seconds=1)) == (
        0,
        (
            'Lookup would require extrapolation into the past.  Requested time 1.000000 but the earliest '
            'data is at time '
            '2.000000, when looking up transform from frame [a] to frame [world]'
        ),
    )
    with pytest.raises(TypeError, match='duration must have sec and nanosec, or nanoseconds'):
        BufferCore(10.0)


def test_answers_of_can_transform_are_integers(buffer):
    assert repr(buffer.can_transform_core('world', 'turtle1', Time())) == "(1, '')"
    assert buffer.can_transform_full_core('turtle1', Time(seconds=6), 'turtle1', Time(seconds=5), 'world') == (1, '')
    assert buffer.can_transform_core('world', 'x', Time())[0] == 0


@pytest.mark.parametrize(
    ('target', 'source', 'time', 'kind', 'text'),
    [
        ('world', 'x', 0, 'LookupException', '"x" passed to lookupTransform argument source_frame does not exist. '),
        (
            'world',
            '/turtle1',
            0,
            'InvalidArgumentException',
            (
                'Invalid argument "/turtle1" passed to lookupTransform argument source_frame - in tf2 '
                'frame_ids cannot start '
                "with a '/'"
            ),
        ),
        (
            'world',
            'turtle1',
            7,
            'ExtrapolationException',
            (
                'Lookup would require extrapolation into the future.  Requested time 7.000000 but the latest '
                'data is at time '
                '6.000000, when looking up transform from frame [turtle1] to frame [world]'
            ),
        ),
        (
            'moon',
            'turtle1',
            0,
            'ConnectivityException',
            (
                "Could not find a connection between 'moon' and 'turtle1' because they are not part of the "
                'same tree.Tf has two '
                'or more unconnected trees.'
            ),
        ),
    ],
)
def test_each_failure_has_its_exception(buffer, target, source, time, kind, text):
    buffer.set_transform(stamped('moon', 'crater', 5, 0.0), 'me')
    with pytest.raises(tf2_py.TransformException) as caught:
        buffer.lookup_transform_core(target, source, Time(seconds=time))
    assert type(caught.value) is getattr(tf2_py, kind)
    assert str(caught.value) == text


def test_exceptions_print_as_those_of_tf2():
    kinds = [
        tf2_py.LookupException,
        tf2_py.ConnectivityException,
        tf2_py.ExtrapolationException,
        tf2_py.InvalidArgumentException,
        tf2_py.TimeoutException,
    ]
    assert all(issubclass(kind, tf2_py.TransformException) and kind.__module__ == 'tf2' for kind in kinds)


def test_the_latest_common_time_is_an_rclpy_time(buffer):
    assert buffer.get_latest_common_time('world', 'turtle1') == Time(seconds=6)
    buffer.set_transform(stamped('moon', 'crater', 5, 0.0), 'me')
    with pytest.raises(tf2_py.TransformException) as caught:
        buffer.get_latest_common_time('world', 'crater')
    assert type(caught.value) is tf2_py.TransformException
    with pytest.raises(tf2_py.LookupException, match='"z" passed to get_latest_common_time does not exist. '):
        buffer.get_latest_common_time('world', 'z')


def test_a_static_transform_holds_at_any_time(buffer):
    buffer.set_transform_static(stamped('turtle1', 'hat', 3, 1.0), 'me')
    assert buffer.lookup_transform_core('turtle1', 'hat', Time(seconds=99)).header.stamp.sec == 99


def test_a_full_lookup_spans_time(buffer):
    found = buffer.lookup_transform_full_core('turtle1', Time(seconds=6), 'turtle1', Time(seconds=5), 'world')
    assert (found.transform.translation.x, found.header.stamp.sec) == (-1.0, 6)


def test_a_translation_of_another_type_is_refused_and_a_rotation_warned_about(buffer):
    fake = SimpleNamespace(header=stamped('a', 'b', 5, 1.0).header, child_frame_id='b')
    fake.transform = SimpleNamespace(translation=SimpleNamespace(x=1.0), rotation=None)
    with (
        pytest.warns(UserWarning, match='Vector3'),
        pytest.raises(TypeError, match=r'^transform\.translation must have members x, y, z$'),
    ):
        buffer.set_transform(fake, 'me')
    fake.transform = SimpleNamespace(
        translation=stamped('a', 'b', 5, 1.0).transform.translation, rotation=SimpleNamespace(x=0.0, y=0.0, z=0.0, w=1.0)
    )
    with pytest.warns(UserWarning, match='Quaternion'):
        buffer.set_transform(fake, 'me')
    assert buffer.lookup_transform_core('a', 'b', Time()).transform.translation.x == 1.0


def test_frames_can_be_listed(buffer):
    assert buffer.all_frames_as_string() == 'Frame turtle1 exists with parent world.\n'
    assert buffer.all_frames_as_yaml().startswith("turtle1: \n  parent: 'world'\n  broadcaster: 'default_authority'\n")
    assert buffer._getFrameStrings() == ['turtle1', 'world']
    assert (buffer._frameExists('world'), buffer._frameExists('x')) == (True, False)
    assert buffer._allFramesAsDot(time=Time(seconds=7)).endswith('}')
    assert buffer._chain(
        target_frame='world', target_time=Time(), source_frame='turtle1', source_time=Time(), fixed_frame='world'
    ) == ['turtle1', 'world']


def test_a_velocity_is_a_pair_of_triples(buffer):
    linear, angular = buffer.lookupVelocityCore('turtle1', 'world', Time(), Duration(seconds=1.0))
    assert (linear, angular) == (pytest.approx((1.0, 0.0, 0.0)), (0.0, 0.0, 0.0))


def test_clear_forgets_moving_frames(buffer):
    buffer.clear()
    assert buffer.can_transform_core('world', 'turtle1', Time())[0] == 0
