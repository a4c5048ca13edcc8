"""The text dumps, character by character."""

from __future__ import annotations

from edulaunch.engine.tf import TransformBuffer
from edulaunch.engine.tf.dumps import seconds_text

from .shapes import SECOND, at

START = 1_700_000_000 * SECOND


def turtle_world() -> TransformBuffer:
    buffer = TransformBuffer()
    for index in range(50):
        buffer.set('world', 'turtle1', START + index * 16_000_000, at(1.0))
    buffer.set('world', 'lamp', 0, at(2.0), static=True)
    return buffer


def test_yaml_lists_the_children_in_order_of_first_mention():
    assert turtle_world().all_frames_as_yaml() == (
        "turtle1: \n  parent: 'world'\n  broadcaster: 'default_authority'\n  rate: 63.776\n"
        '  most_recent_transform: 1700000000.784000\n  oldest_transform: 1700000000.000000\n  '
        'buffer_length: 0.784\n'
        "lamp: \n  parent: 'world'\n  broadcaster: 'default_authority'\n  rate: 10000.000\n"
        '  most_recent_transform: 0.000000\n  oldest_transform: 0.000000\n  buffer_length: 0.000\n'
    )


def test_yaml_of_an_empty_buffer_is_an_empty_list_and_cleared_frames_are_left_out():
    assert TransformBuffer().all_frames_as_yaml() == '[]'
    buffer = TransformBuffer()
    buffer.set('w', 'a', SECOND, at(1.0))
    buffer.clear()
    assert buffer.all_frames_as_yaml() == ''


def test_the_plain_list_names_parents():
    buffer = turtle_world()
    assert buffer.all_frames_as_string() == ('Frame turtle1 exists with parent world.\nFrame lamp exists with parent world.\n')
    buffer.clear()
    assert buffer.all_frames_as_string().startswith('Frame turtle1 exists with parent NO_PARENT.\n')


def test_dot_shows_an_arrow_for_each_child_and_the_age_when_asked():
    buffer = turtle_world()
    assert buffer.all_frames_as_dot().splitlines()[1] == (
        '"world" -> "turtle1"[label="Broadcaster: default_authority\\nAverage rate: 63.776 Hz\\n'
        'Most recent transform: 1700000000.784000 \\nBuffer length: 0.784 sec\\n"];'
    )
    text = buffer.all_frames_as_dot(START + SECOND)
    assert '1700000000.784000 ( 0.216 sec old)\\n' in text
    assert text.endswith('"Recorded at time: 1700000001.000000"[ shape=plaintext ] ;\n}->"world";\n}')


def test_dot_of_an_empty_buffer_says_so():
    assert 'no tf data' in TransformBuffer().all_frames_as_dot()


def test_seconds_have_six_decimals():
    assert [seconds_text(time) for time in (0, 5, 1_700_000_005_000_000_000, 1_500_000_499)] == [
        '0.000000',
        '0.000000',
        '1700000005.000000',
        '1.500000',
    ]
