from __future__ import annotations

from pathlib import Path

from edulaunch.extras.comparing.observation import BRIEFLY, End
from edulaunch.extras.comparing.simulated import simulate


def test_what_is_seen_of_a_simulated_run() -> None:
    seen = simulate('demo_nodes_cpp', 'talker_listener_launch.py', {}, 6.0, [])
    assert seen.nodes == {'/talker': 0.0, '/listener': 0.0}
    assert seen.ends[End('publisher', '/chatter', 'std_msgs/msg/String', '/talker')] == ('reliable volatile', 0.0)
    assert seen.parameters['/talker']['use_sim_time'] is False
    assert str(seen.flows['/chatter'].fields['data'].range) == "'Hello World: #'"
    assert len(seen.flows['/chatter'].times) == 6
    assert '[INFO] [#] [listener]: I heard: [Hello World: #]' in {line.text for line in seen.lines if line.process == 'listener'}
    assert seen.codes == {'talker': [0], 'listener': [0]}


def test_a_node_that_was_there_only_briefly_need_not_be_found(tmp_path) -> None:  # type: ignore[no-untyped-def]
    file = tmp_path / 'x.launch.xml'
    nodes = ''.join(f'<node pkg="demo_nodes_py" exec="add_two_ints_{end}"/>' for end in ('server', 'client'))
    file.write_text(f'<launch>{nodes}</launch>')
    seen = simulate(str(file), None, {}, 6.0, [])
    assert seen.nodes == {'/add_two_ints_server': 0.0, '/add_two_ints_client': BRIEFLY}
    assert {when for end, (_, when) in seen.ends.items() if end.node == '/add_two_ints_client'} == {BRIEFLY}


BRIEF = """
import rclpy, rclpy.qos
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('brief')
brief, lasting = (node.create_publisher(String, name, 10) for name in ('brief', 'lasting'))
for depth in (10, rclpy.qos.QoSProfile(depth=1, durability=rclpy.qos.DurabilityPolicy.TRANSIENT_LOCAL)):
    node.create_publisher(String, 'twice', depth)
node.create_timer(2.0, lambda: node.destroy_publisher(brief))
node.create_timer(5.0, lambda: node.create_publisher(String, 'last', 10))
rclpy.spin(node)
"""


def test_a_publisher_that_was_there_only_briefly_need_not_be_found(tmp_path: Path) -> None:
    (tmp_path / 'brief.py').write_text(BRIEF)
    file = tmp_path / 'x.launch.xml'
    file.write_text(f'<launch><executable cmd="python3 {tmp_path}/brief.py"/></launch>')
    seen = simulate(str(file), None, {}, 6.0, [])
    made = {end.name: row for end, row in seen.ends.items() if end.kind == 'publisher' and end.type == 'std_msgs/msg/String'}
    usual = 'reliable volatile'
    assert made == {'/brief': (usual, BRIEFLY), '/lasting': (usual, 0.0), '/twice': (usual, 0.0), '/last': (usual, 5.0)}


def test_programs_of_this_computer_are_seen(tmp_path: Path) -> None:
    file = tmp_path / 'x.launch.xml'
    file.write_text('<launch><executable cmd="expr 6 + 1" name="seven"/><executable cmd="false" name="false"/></launch>')
    seen = simulate(str(file), None, {}, 3.0, [])
    assert [(line.process, line.text) for line in seen.lines] == [('seven', '#')]
    assert seen.codes == {'seven': [0], 'false': [1]}
