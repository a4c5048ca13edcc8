"""`ros2 bag ...` in the simulation; read back with rosbags."""

from __future__ import annotations

from pathlib import Path

import pytest


def logged(text: str) -> list[str]:
    return [line.partition(']: ')[2] for line in text.splitlines()]


def read(bag: Path) -> list[tuple[int, str, object]]:
    pytest.importorskip('rosbags')
    from rosbags.highlevel import AnyReader

    with AnyReader([bag]) as reader:
        return [
            (time, connection.topic, reader.deserialize(data, connection.msgtype)) for connection, time, data in reader.messages()
        ]


def test_record_all_logs_what_it_hears_and_writes_on_ctrl_c(machine) -> None:
    pytest.importorskip('rosbags')
    typed = machine.run('ros2 bag record -a', 0.5)
    typed.interrupt()
    assert logged(typed.err) == [
        'Press SPACE for pausing/resuming',
        'Listening for topics...',
        'Event publisher thread: Starting',
        "Subscribed to topic '/parameter_events'",
        "Subscribed to topic '/rosout'",
        "Subscribed to topic '/turtle1/color_sensor'",
        "Subscribed to topic '/turtle1/pose'",
        'Recording...',
        'Event publisher thread: Exiting',
        'Recording stopped',
    ]
    assert typed.code == 0
    assert sorted(path.name for path in (machine.folder / 'rosbag2_2023_11_14-22_13_21').iterdir()) == [
        'metadata.yaml',
        'rosbag2_2023_11_14-22_13_21.mcap',
    ]


@pytest.mark.parametrize('storage', ['mcap', 'sqlite3'])
def test_a_bag_holds_the_messages_at_their_times(machine, storage: str) -> None:
    typed = machine.start(f'ros2 bag record -s {storage} -o subset turtle1/cmd_vel /turtle1/pose')
    machine.session.run(0.05)
    machine.run("ros2 topic pub -r 5 /turtle1/cmd_vel geometry_msgs/msg/Twist '{linear: {x: 2}}'", 0.45)
    typed.interrupt()
    assert 'All requested topics are subscribed. Stopping discovery...' in logged(typed.err)
    start = machine.session.sim.start_ns
    commands = [
        ((time - start) / 1e9, message.linear.x)
        for time, topic, message in read(machine.folder / 'subset')
        if topic == '/turtle1/cmd_vel'
    ]
    assert commands == [(1.25, 2.0), (1.45, 2.0)]


def test_a_topic_is_found_when_it_appears(machine) -> None:
    typed = machine.start('ros2 bag record /late')
    machine.session.run(0.25)
    machine.run('ros2 topic pub /late std_msgs/msg/Empty')
    assert typed.writes[-2][0] == 1.3 and typed.writes[-2][1].endswith("Subscribed to topic '/late'\n")


def test_without_rosbags_the_recorder_says_so_and_goes_on(machine, monkeypatch) -> None:
    from importlib import util

    found = util.find_spec
    monkeypatch.setattr('edulaunch.cli.ros2.bag.record.find_spec', lambda name: None if name == 'rosbags' else found(name))
    typed = machine.run('ros2 bag record -a')
    typed.interrupt()
    warnings = [line for line in typed.err.splitlines() if line.startswith('[WARN]')]
    assert len(warnings) == 1 and 'pip install edulaunch[bags]' in warnings[0]
    assert typed.code == 0 and list(machine.folder.iterdir()) == []


def test_record_wants_topics_and_a_new_folder(machine) -> None:
    assert 'write `ros2 bag record -a`' in machine.fails('ros2 bag record')
    (machine.folder / 'old').mkdir()
    assert machine.fails('ros2 bag record -a -o old').endswith("old' already exists.\n")


def test_regex_and_exclude_choose_topics(machine) -> None:
    typed = machine.run('ros2 bag record -e turtle1 -x color')
    assert [line for line in logged(typed.err) if line.startswith('Subscribed')] == ["Subscribed to topic '/turtle1/pose'"]


def test_play_repeats_what_was_recorded(machine) -> None:
    pytest.importorskip('rosbags')
    recorder = machine.start('ros2 bag record -o drive /turtle1/cmd_vel')
    machine.run("ros2 topic pub -t 2 -r 2 /turtle1/cmd_vel geometry_msgs/msg/Twist '{linear: {x: 2}}'", 1.0)
    recorder.interrupt()
    heard = machine.start('ros2 topic echo /turtle1/cmd_vel geometry_msgs/msg/Twist --field linear.x')
    began = machine.now()
    played = machine.run('ros2 bag play drive -r 2', 1.0)
    assert (played.code, heard.writes[0]) == (0, (began, '2.0\n---\n'))
    assert 'Topic: /turtle1/cmd_vel | Type: geometry_msgs/msg/Twist | Count: 1 | ' in machine.read('ros2 bag info drive')


def test_info_of_no_bag(machine) -> None:
    assert machine.fails('ros2 bag info nix').startswith("[ERROR] [ros2bag]: bag path 'nix' does not exist!\n")
