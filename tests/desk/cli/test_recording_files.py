"""`edulaunch recording show|export`: pages, pictures, bags and tables of a recording."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from edulaunch.desk.cli.main import main
from edulaunch.engine.recording import Recording
from edulaunch.ros.serialization.cdr import encode


@pytest.fixture(scope='module')
def drive(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording of a turtle that is told to drive."""
    folder = tmp_path_factory.mktemp('drive')
    (folder / 'drive.launch.py').write_text(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\nfrom launch_ros.actions import Node\n'
        'def generate_launch_description():\n'
        '    return LaunchDescription([Node(package="turtlesim", executable="turtlesim_node"), ExecuteProcess(cmd=["ros2", "topic",'
        '"pub", "-r", "4", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", "{linear: {x: 2.0}}"])])\n'
    )
    words = [str(folder / 'drive.launch.py'), '--fast', '--for', '2', '--record', str(folder / 'drive.rec')]
    assert main(['launch', *words]) == 0
    return folder / 'drive.rec'


def test_a_page_and_pictures_are_written_and_named(drive: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['recording', 'show', str(drive)]) == 0
    page = drive.with_suffix('.html')
    assert capsys.readouterr().out == f'{page}\n'
    assert page.read_text().startswith('<!DOCTYPE html>') and 'drive.launch.py' in page.read_text()
    for what in ('turtles', 'graph'):
        picture = drive.parent / f'{what}.png'
        assert main(['recording', 'show', str(drive), '--png', str(picture), '--what', what, '--at', '1']) == 0
        assert picture.read_bytes().startswith(b'\x89PNG')
    assert main(['recording', 'show', str(drive), '--png', '/nowhere/x.png']) == 2


def test_the_messages_become_a_bag(drive: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from rosbags.highlevel import AnyReader

    folder = drive.parent / 'bag'
    assert main(['recording', 'export', str(drive), '--bag', str(folder), '--topics', '/turtle1/cmd_vel']) == 0
    with AnyReader([folder]) as reader:
        speeds = [reader.deserialize(data, connection.msgtype).linear.x for connection, _, data in reader.messages()]
        times = [time for _, time, _ in reader.messages()]
    assert speeds == [2.0] * len(times)
    assert {after - before for before, after in zip(times, times[1:], strict=False)} == {250_000_000}
    assert main(['recording', 'export', str(drive), '--bag', str(folder)]) == 2
    assert 'already exists' in capsys.readouterr().err


def test_one_mcap_file_is_read_by_two_other_libraries(drive: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Each message has the time and the CDR bytes of the recording; an index lets a reader begin anywhere."""
    from mcap.reader import SeekingReader, make_reader
    from mcap_ros2.decoder import DecoderFactory
    from rosbags.highlevel import AnyReader

    path = drive.with_suffix('.mcap')
    assert main(['recording', 'export', str(drive), '--mcap']) == 0
    assert capsys.readouterr().out == f'{path}\n'
    recording = Recording.load(drive)
    wanted = [
        (topic, recording.start_ns + time_ns, encode(recording.message_class(record.type), wire))
        for topic, record in recording.topics.items()
        for time_ns, wire in recording.wires(topic, record.type)
    ]
    with path.open('rb') as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        assert isinstance(reader, SeekingReader)
        rows = list(reader.iter_decoded_messages())
        found = [(channel.topic, message.log_time, message.data) for _, channel, message, _ in rows]
        speeds = {decoded.linear.x for _, channel, _, decoded in rows if channel.topic == '/turtle1/cmd_vel'}
        late = [one.log_time for _, _, one in reader.iter_messages(['/turtle1/pose'], starting_at=recording.start_ns + 10**9)]
    assert sorted(found) == sorted(wanted) and speeds == {2.0}
    assert late == [time_ns for topic, time_ns, _ in wanted if topic == '/turtle1/pose' and time_ns >= recording.start_ns + 10**9]
    with AnyReader([path]) as other:
        assert sorted((connection.topic, time_ns, data) for connection, time_ns, data in other.messages()) == sorted(wanted)


def test_the_same_recording_gives_the_same_mcap_file(drive: Path) -> None:
    paths = [drive.parent / name for name in ('one.mcap', 'folder/another.mcap')]
    paths[1].parent.mkdir()
    for path in paths:
        assert main(['recording', 'export', str(drive), '--mcap', str(path)]) == 0
    assert paths[0].read_bytes() == paths[1].read_bytes()
    assert [path.name for path in paths[1].parent.iterdir()] == ['another.mcap']


def test_an_mcap_file_that_is_there_or_has_no_folder(drive: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['recording', 'export', str(drive), '--mcap', str(drive)]) == 2
    assert main(['recording', 'export', str(drive), '--mcap', str(drive.parent / 'nowhere' / 'x.mcap')]) == 2
    first, _, second = capsys.readouterr().err.partition('error: ')[2].partition('error: ')
    assert 'already exists' in first and 'cannot write ' in second and 'x.mcap: No such file or directory' in second


def test_each_topic_becomes_a_table(drive: Path) -> None:
    assert main(['recording', 'export', str(drive), '--csv']) == 0
    folder = drive.parent / 'drive_csv'
    rows = list(csv.reader((folder / 'turtle1.pose.csv').read_text().splitlines()))
    assert rows[0] == ['time', 'x', 'y', 'theta', 'linear_velocity', 'angular_velocity']
    assert len(rows) > 100 and float(rows[-1][1]) > float(rows[1][1]) == pytest.approx(5.544445)
    assert (folder / 'turtle1.cmd_vel.csv').read_text().splitlines()[0].startswith('time,linear.x,linear.y')


def test_a_topic_that_nobody_published_on(drive: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['recording', 'export', str(drive), '--csv', 'x', '--topics', '/nix']) == 2
    assert 'help: choose topics with messages: /' in capsys.readouterr().err


def test_a_recording_over_the_limits_is_read_when_it_is_trusted(
    drive: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr('edulaunch.engine.recording.file_format.MOST_VALUES', 10)
    assert main(['recording', 'info', str(drive)]) != 0
    assert 'more than 10 values' in (refused := capsys.readouterr().err) and '--trusted' in refused
    assert main(['recording', 'info', str(drive), '--trusted']) == 0
