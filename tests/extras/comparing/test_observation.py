from __future__ import annotations

import pytest

from edulaunch.engine.interfaces import current_registry
from edulaunch.extras.comparing.observation import Flow, Values, add_messages, is_compared, lines_of, masked, program_of


@pytest.mark.parametrize(
    ('text', 'expected'),
    [
        (
            '[INFO] [1700000000.250000000] [talker]: Publishing: "Hello World: 12"',
            '[INFO] [#] [talker]: Publishing: "Hello World: #"',
        ),
        ('x=[5.544445], y=[-0.5], 3e-05', 'x=[#], y=[#], #'),
        ("array('i', [0, 1, 1, 2])", "array('i', [#])"),
        ('Goal accepted with ID: 89bb20a184ec40ce8be09e14207ad6ba', 'Goal accepted with ID: #'),
        ('<Future at 0x7f0000000010>  ', '<Future at #>'),
        ('no number at all', 'no number at all'),
    ],
)
def test_what_differs_from_run_to_run_is_masked(text: str, expected: str) -> None:
    assert masked(text) == expected


def test_lines_are_put_together_from_pieces() -> None:
    pieces = [(0.5, 'one\ntw'), (1.0, 'o\n\n'), (2.0, 'rest')]
    assert [(line.text, line.time_s) for line in lines_of('a', pieces)] == [('one', 0.5), ('two', 1.0), ('rest', 2.0)]


def test_of_a_traceback_there_is_only_the_error() -> None:
    text = 'before\nTraceback (most recent call last):\n  File "x.py", line 3, in <module>\n    f()\nValueError: no\n  after\n'
    assert [line.text for line in lines_of('a', [(0.0, text)])] == ['before', 'ValueError: no', '  after']


def test_nodes_of_commands_and_of_launch_are_left_out() -> None:
    nodes = ['/talker', '/_ros2cli_1002', '/launch_ros_1001', '/ns/launch_rosy', '/ns/_hidden']
    assert [node for node in nodes if is_compared(node)] == ['/talker', '/ns/launch_rosy']


def test_a_program_is_known_without_its_number() -> None:
    assert (program_of('talker-12'), program_of('my-node-3'), program_of('odd')) == ('talker', 'my-node', 'odd')


def test_values_remember_when_they_were() -> None:
    values = Values()
    for time_s, value in ((0.0, 1), (1.0, 5.5), (2.0, (-3, 7))):
        values.add(time_s, value)
    assert str(values.range) == '-3 to 7'
    assert str(values.between(0.5, 1.5)) == '5.5'
    assert str(values.between(8, 9)) == 'nothing'


def test_texts_are_a_set() -> None:
    values = Values()
    for number in range(3):
        values.add(0.0, f'Hello World: {number}')
    assert str(values.range) == "'Hello World: #'"


def test_the_fields_of_a_message_without_its_stamps() -> None:
    cls = current_registry().get('geometry_msgs/msg/PoseStamped')
    message = cls()
    message.header.stamp.sec = 1700000000
    message.pose.position.x = 2.0
    flows: dict[str, Flow] = {}
    add_messages(flows, '/pose', cls.TYPE, [(0.25, cls.to_wire(message))], current_registry().get)
    assert flows['/pose'].times == [0.25]
    assert {path: str(values.range) for path, values in flows['/pose'].fields.items()} == {
        'header.frame_id': "''",
        'pose.position.x': '2',
        **dict.fromkeys(('pose.position.y', 'pose.position.z'), '0'),
        **dict.fromkeys((f'pose.orientation.{axis}' for axis in 'xyz'), '0'),
        'pose.orientation.w': '1',
    }


def test_transforms_are_told_apart_by_their_frames() -> None:
    cls, one = current_registry().get('tf2_msgs/msg/TFMessage'), current_registry().get('geometry_msgs/msg/TransformStamped')
    messages = []
    for child, x in (('a', 1.0), ('b', 2.0)):
        transform = one(child_frame_id=child)
        transform.header.frame_id = 'world'
        transform.transform.translation.x = x
        messages.append(transform)
    flows: dict[str, Flow] = {}
    add_messages(flows, '/tf', cls.TYPE, [(0.0, cls.to_wire(cls(transforms=messages)))], current_registry().get)
    assert {name: str(flow.fields['transform.translation.x'].range) for name, flow in flows.items()} == {
        'tf world -> a': '1',
        'tf world -> b': '2',
    }


def test_messages_in_messages_are_looked_into() -> None:
    cls, point = current_registry().get('geometry_msgs/msg/Polygon'), current_registry().get('geometry_msgs/msg/Point32')
    flows: dict[str, Flow] = {}
    wire = cls.to_wire(cls(points=[point(x=1.0), point(x=4.0)]))
    add_messages(flows, '/area', cls.TYPE, [(0.0, wire)], current_registry().get)
    assert str(flows['/area'].fields['points[].x'].range) == '1 to 4'
