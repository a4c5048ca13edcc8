"""The command line programs of tf2_ros and tf2_tools, as started by ros2 run."""

from __future__ import annotations

import re
from math import pi
from pathlib import Path
from typing import Any

import pytest
from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage

from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.tf.quaternions import from_euler
from edulaunch.engine.underlay_place import underlay_prefix

FRAMES = ('--frame-id', 'world', '--child-frame-id', 'mystaticturtle')


def run(stage: Any, package: str, executable: str, *arguments: str, cwd: str | None = None) -> tuple[Process, list]:
    """A started program and the list in which its (milliseconds, stream, text) will stand."""
    output: list[tuple[float, str, str]] = []
    argv = (f'{underlay_prefix()}/lib/{package}/{executable}', *arguments)
    process = stage.host.start(
        ProcessSpec(argv=argv, name=executable, cwd=cwd),
        on_output=lambda stream, text: output.append((stage.tape.now_ms(), stream, text)),
    )
    return process, output


def text_of(output: list, stream: str = 'stdout') -> str:
    return ''.join(text for _, name, text in output if name == stream)


def send(stage: Any, *frames: tuple[str, str, float, float], delay_s: float = 0.0) -> None:
    """Publish parent -> child, x, yaw, stamped `delay_s` before now."""
    stamp = divmod(stage.sim.now_ns - round(delay_s * 1e9), 10**9)
    stage.publish(
        '/tf',
        TFMessage(
            transforms=[
                TransformStamped.from_wire((*stamp, parent, child, x, 0.0, 0.0, *from_euler(0.0, 0.0, yaw)))
                for parent, child, x, yaw in frames
            ]
        ),
    )


def test_a_static_publisher_sends_once_says_what_in_four_lines_and_stays(stage):
    process, output = run(stage, 'tf2_ros', 'static_transform_publisher', '--z', '1', *FRAMES)
    stage.until(5000)
    (sent,) = stage.messages('/tf_static')
    assert TransformStamped.to_wire(sent.transforms[0]) == (
        1700000000,
        0,
        'world',
        'mystaticturtle',
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
    )
    assert re.fullmatch(
        r'\[INFO\] \[1700000000\.0+\] \[static_transform_publisher_[A-Za-z0-9]{16}\]: '
        r'Spinning until stopped - publishing transform\n'
        r"translation: \('0\.000000', '0\.000000', '1\.000000'\)\n"
        r"rotation: \('0\.000000', '0\.000000', '0\.000000', '1\.000000'\)\n"
        r"from 'world' to 'mystaticturtle'\n",
        text_of(output, 'stderr'),
    )
    assert process.returncode is None


def test_a_static_publisher_can_be_renamed_and_shows_read_only_parameters(stage):
    run(
        stage,
        'tf2_ros',
        'static_transform_publisher',
        '--x',
        '2',
        '--yaw',
        '3.141592653589793',
        *FRAMES,
        '--ros-args',
        '-r',
        '__node:=lamp',
    )
    stage.until(10)
    from rcl_interfaces.srv import GetParameters, SetParameters

    values = stage.ask('/lamp/get_parameters', GetParameters, names=['translation.x', 'rotation.z', 'frame_id'])
    from rclpy.parameter import Parameter

    refused = stage.ask(
        '/lamp/set_parameters', SetParameters, parameters=[Parameter('frame_id', value='moon').to_parameter_msg()]
    )
    stage.until(20)
    found = values[0].values
    assert (found[0].double_value, found[1].double_value, found[2].string_value) == (2.0, 1.0, 'world')
    assert not refused[0].results[0].successful


def test_old_style_arguments_work_with_a_warning(stage):
    _, output = run(stage, 'tf2_ros', 'static_transform_publisher', *['1', '2', '3', '0', '0', '0', 'world', 'child'])
    stage.until(10)
    assert text_of(output, 'stderr').startswith(
        '[WARN] [1700000000.000000000] []: Old-style arguments are deprecated; see --help for new-style arguments\n'
    )
    assert stage.messages('/tf_static')[0].transforms[0].transform.translation.y == 2.0


@pytest.mark.parametrize(
    ('arguments', 'stderr', 'code'),
    [
        (
            ('--x', '1'),
            ('[ERROR] [1700000000.000000000] []: error parsing command line arguments: Frame id must not be empty\n'),
            1,
        ),
        (('--help',), '', 0),
    ],
)
def test_usage_is_printed_with_the_reason_on_stderr(stage, arguments, stderr, code):
    process, output = run(stage, 'tf2_ros', 'static_transform_publisher', *arguments)
    stage.until(10)
    assert (text_of(output, 'stderr'), process.returncode) == (stderr, code)
    assert text_of(output).startswith('usage: static_transform_publisher [--x X]')


def test_equal_frames_abort_the_static_publisher(stage):
    process, output = run(stage, 'tf2_ros', 'static_transform_publisher', '--frame-id', 'a', '--child-frame-id', 'a')
    stage.until(10)
    assert "]: cannot publish static transform from 'a' to 'a', exiting\n" in text_of(output, 'stderr')
    assert text_of(output, 'stderr').endswith(
        "terminate called after throwing an instance of 'std::runtime_error'\n  what():  child_frame_id cannot equal frame_id\n"
    )
    assert process.returncode == -6


def test_echo_waits_and_then_prints_ten_lines_each_second(stage):
    _, output = run(stage, 'tf2_ros', 'tf2_echo', 'world', 'turtle1')
    stage.until(5)
    send(stage, ('world', 'turtle1', 4.541, pi + 0.07))
    stage.until(1500)
    assert output == [
        (
            0.0,
            'stderr',
            (
                '[INFO] [1700000000.000000000] [tf2_echo]: Waiting for transform world ->  turtle1: Invalid '
                'frame ID "world" passed to canTransform argument target_frame - frame does not exist\n'
            ),
        ),
        (
            1000.0,
            'stdout',
            (
                'At time 1700000000.5000000\n- Translation: [4.541, 0.000, 0.000]\n'
                '- Rotation: in Quaternion [0.000, 0.000, 0.999, -0.035]\n'
                '- Rotation: in RPY (radian) [0.000, -0.000, -3.072]\n'
                '- Rotation: in RPY (degree) [0.000, -0.000, -175.989]\n'
                '- Matrix:\n -0.998  0.070  0.000  4.541\n -0.070 -0.998  0.000  0.000\n'
                '  0.000  0.000  1.000  0.000\n'
                '  0.000  0.000  0.000  1.000\n'
            ),
        ),
    ]


def test_echo_complains_once_a_second_until_there_is_a_transform(stage):
    _, output = run(stage, 'tf2_ros', 'tf2_echo', 'world', 'turtle1', '10')
    stage.until(2500)
    assert [at for at, _, text in output if 'Waiting for transform' in text] == [0.0, 1000.0, 2000.0]


def test_echo_of_a_negative_turn_shows_negative_zeros_as_ros_does(stage):
    send_first = [('world', 'turtle1', 1.256, -0.032)]
    _, output = run(stage, 'tf2_ros', 'tf2_echo', 'world', 'turtle1', '2.0')
    stage.until(5)
    send(stage, *send_first)
    stage.until(600)
    assert text_of(output).splitlines()[3:9] == [
        '- Rotation: in RPY (radian) [0.000, 0.000, -0.032]',
        '- Rotation: in RPY (degree) [0.000, 0.000, -1.833]',
        '- Matrix:',
        '  0.999  0.032  0.000  1.256',
        ' -0.032  0.999 -0.000  0.000',
        ' -0.000  0.000  1.000  0.000',
    ]


def test_echo_tells_when_a_transform_is_lost(stage):
    _, output = run(stage, 'tf2_ros', 'tf2_echo', 'world', 'turtle1')
    stage.until(5)
    send(stage, ('world', 'turtle1', 1.0, 0.0))
    stage.until(1500)
    send(stage, ('moon', 'turtle1', 1.0, 0.0))
    stage.until(2100)
    assert text_of(output).split('Failure at ')[1] == (
        "1700000002.000\nException thrown:Could not find a connection between 'world' and 'turtle1' "
        'because they are '
        'not part of the same tree.Tf has two or more unconnected trees.\nThe current list of frames is:\n'
        'Frame turtle1 exists with parent moon.\n\n'
    )


@pytest.mark.parametrize(
    ('arguments', 'stdout', 'stderr', 'code'),
    [
        (('world',), 'Usage: tf2_echo source_frame target_frame [echo_rate]\n', '', 1),
        (('a', 'b', 'fast'), '', "Failed to convert rate argument 'fast' to a floating-point number\n", 2),
    ],
)
def test_echo_refuses_bad_arguments(stage, arguments, stdout, stderr, code):
    process, output = run(stage, 'tf2_ros', 'tf2_echo', *arguments)
    stage.until(10)
    assert (text_of(output)[: len(stdout)], text_of(output, 'stderr'), process.returncode) == (stdout, stderr, code)


def test_monitor_reports_delays_every_21_half_seconds(stage):
    _, output = run(stage, 'tf2_ros', 'tf2_monitor', 'turtle2', 'turtle1')
    for tenth in range(1, 107):
        stage.until(tenth * 100 - 50)
        send(stage, ('world', 'turtle1', 1.0, 0.0), ('world', 'turtle2', 2.0, 0.0), delay_s=0.05)
    stage.until(10600)
    assert text_of(output).split('Net delay')[0] == (
        'Gathering data on turtle2 -> turtle1 for 10 seconds...\n\n\n\nRESULTS: for turtle2 to turtle1\n'
        'Chain is: turtle2 -> world -> turtle1\n'
    )
    assert text_of(output).splitlines()[-4:] == [
        'Frames:',
        *(
            f'Frame: {name}, published by <no authority available>, Average Delay: 0.05, Max Delay: 0.05'
            for name in ('turtle1', 'turtle2')
        ),
        'Node: <no authority available> 10.0962 Hz, Average Delay: 0.05 Max Delay: 0.05',
    ]
    assert text_of(output, 'stderr').endswith('\nAll Broadcasters:\n')


def test_monitor_of_all_frames_names_none(stage):
    _, output = run(stage, 'tf2_ros', 'tf2_monitor')
    stage.until(100)
    send(stage, ('world', 'turtle1', 1.0, 0.0))
    stage.until(10600)
    assert text_of(output).startswith(
        'Gathering data on all frames for 10 seconds...\n\n\n\nRESULTS: for all Frames\n\nFrames:\nFrame: turtle1, '
    )


def test_view_frames_writes_the_graph_and_a_page_without_graphviz(stage, tmp_path: Path):
    process, output = run(stage, 'tf2_tools', 'view_frames', '-o', str(tmp_path / 'tree'))
    for tenth in range(1, 70):
        stage.until(tenth * 100)
        send(stage, ('world', 'turtle1', 1.0, 0.0))
    assert process.returncode == 0
    lines = [line.partition(']: ')[2] for line in text_of(output, 'stderr').splitlines()]
    assert lines[:2] == ['Listening to tf data for 5.0 seconds...', 'Generating graph...']
    assert lines[2].startswith("Result:tf2_msgs.srv.FrameGraph_Response(frame_yaml=\"turtle1: \\n  parent: 'world'")
    assert lines[3] == f'Exporting graph in {tmp_path}/tree.pdf file...'
    assert len(lines) == 4
    assert (tmp_path / 'tree.pdf').read_bytes().startswith(b'%PDF-')
    graph = (tmp_path / 'tree.gv').read_text()
    assert graph.startswith('digraph G {\n"world" -> "turtle1"[label=" Broadcaster: default_authority\\nAverage rate: 10.2')
    assert re.search(r'"Recorded at time: 1700000005\.\d+"\[ shape=plaintext \] ;\n}->"world";\n}$', graph)


def test_view_frames_names_its_files_after_the_simulated_date(stage, tmp_path: Path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run(stage, 'tf2_tools', 'view_frames', '-t', '0.5')
    stage.until(1000)
    (file,) = tmp_path.glob('frames_2023-11-*.gv')
    assert file.read_text() == 'digraph G { "No tf data received" }'


def test_a_program_of_ours_that_ctrl_c_ends_shows_no_frames_of_ours(stage, tmp_path: Path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    process, output = run(stage, 'tf2_tools', 'view_frames')
    stage.until(1000)
    process.send_signal(2)
    stage.until(1100)
    assert text_of(output, 'stderr').splitlines()[-1] == 'KeyboardInterrupt'
    assert 'Traceback' not in text_of(output, 'stderr')
