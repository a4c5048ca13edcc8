"""A machine that runs for hours keeps a bounded past."""

from __future__ import annotations

from edulaunch import Session


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
