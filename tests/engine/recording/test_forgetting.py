"""A machine that runs for hours keeps a bounded past."""

from __future__ import annotations

from pathlib import Path

from edulaunch import Session
from edulaunch.engine.processes.spec import ProcessSpec


def test_old_messages_and_lines_go_the_last_ones_stay() -> None:
    with Session() as session:
        session.launch('turtlesim', 'multisim.launch.py')
        session.run(10)
        recorder = session.recorder
        before = {key: len(flat) // 3 for key, flat in recorder.columns.items()}
        recorder.forget_before(session.sim.now_ns - 2_000_000_000, kept=3)
        after = {key: len(flat) // 3 for key, flat in recorder.columns.items()}
        pose = ('/turtlesim1/turtle1/pose', 'turtlesim/msg/Pose')
        assert before[pose] > 600 and 124 <= after[pose] <= 126
        parameters = ('/parameter_events', 'rcl_interfaces/msg/ParameterEvent')
        assert after[parameters] == min(3, before[parameters])
        assert not recorder.output_lines and not recorder.logs
        session.run(1)
        recording = session.recording()
        assert recording.messages('/turtlesim1/turtle1/pose')[-1][0] > 10.9
        assert [node.name for node in recording.nodes] == ['/turtlesim1/turtlesim', '/turtlesim2/turtlesim']


def test_nothing_is_kept_of_programs_and_nodes_that_have_ended_but_their_rows() -> None:
    with Session() as session:
        launch = session.launch('turtlesim', 'multisim.launch.py')
        session.run(1)
        launch.interrupt()
        session.run(10)
        assert launch.is_over
        assert not session.recorder._process_row and not session.recorder._node_row
        assert all(row['returncode'] == 0 for row in session.recorder.processes)


def test_what_comes_and_goes_leaves_nothing_behind_and_what_stays_keeps_its_parameters() -> None:
    """But the last messages of a topic, and who published them: here those of the last visitor."""
    with Session() as session:
        session.host.start(ProcessSpec(argv=('ros2', 'run', 'turtlesim', 'turtlesim_node'), name='stays'))
        sizes = []
        for visit in range(6):
            guest = session.host.start(ProcessSpec(argv=('ros2', 'run', 'demo_nodes_py', 'listener'), name=f'guest{visit}'))
            session.run(1)
            guest.send_signal(2)
            session.run(20)
            session.recorder.forget_before(session.sim.now_ns - 10**10, kept=2)
            parts = ('endpoints', 'nodes', 'processes', 'parameters', 'descriptors', 'facts', 'notes', 'logs')
            sizes.append({part: len(getattr(session.recorder, part)) for part in parts})
        assert sizes[3:] == [sizes[2]] * 3
        content = session.recorder.content()
        assert [row[0] for row in content['nodes']] == ['/turtlesim', '/listener']
        assert [row['name'] for row in content['processes']] == ['stays', 'stays']
        assert ['/turtlesim', 'background_g', 86] in [row[1:4] for row in content['parameters']]
        assert {row[3] for row in content['endpoints']} == {row[4] for row in content['nodes']}


def test_topics_and_programs_with_new_names_leave_nothing_but_names_behind(tmp_path: Path) -> None:
    script = tmp_path / 'says.py'
    script.write_text(
        'import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\nrclpy.init()\nnode = Node("says")\n'
        'publisher = node.create_publisher(String, "said", 10)\n'
        'node.create_timer(0.1, lambda: publisher.publish(String(data="hello")))\nrclpy.spin(node)\n'
    )
    with Session() as session:
        recorder, sizes = session.recorder, []
        for visit in range(3):
            words = ('python3', str(script), '--ros-args', '-r', f'__ns:=/visit{visit}')
            guest = session.host.start(ProcessSpec(argv=words, name=f'guest{visit}'))
            session.run(1)
            assert any(file == str(script) for file, _ in recorder.lines.values())
            recorder.forget_before(session.sim.now_ns, kept=2)
            assert len(recorder.columns[f'/visit{visit}/said', 'std_msgs/msg/String']) == 2 * 3
            guest.send_signal(2)
            session.run(20)
            recorder.forget_before(session.sim.now_ns - 10**10, kept=2)
            sizes.append((recorder.publication_count(), len(recorder.endpoints), len(recorder.nodes), len(recorder.lines)))
        assert sizes == [(0, 0, 0, 0)] * 3
        assert recorder.forgotten['/visit0/said', 'std_msgs/msg/String'] > 5
