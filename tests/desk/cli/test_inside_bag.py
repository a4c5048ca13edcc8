"""`ros2 bag ...` in the simulation; read back with rosbags."""

from __future__ import annotations

import itertools
import re
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.processes.inputs import TypedInput


def logged(text: str) -> list[str]:
    return [line.partition(']: ')[2] for line in text.splitlines()]


def read(bag: Path) -> list[tuple[int, str, object]]:
    from rosbags.highlevel import AnyReader

    with AnyReader([bag]) as reader:
        return [
            (time, connection.topic, reader.deserialize(data, connection.msgtype)) for connection, time, data in reader.messages()
        ]


def test_record_all_logs_what_it_hears_and_writes_on_ctrl_c(machine) -> None:
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
    [bag] = machine.folder.iterdir()
    assert re.fullmatch(r'rosbag2_\d{4}_\d\d_\d\d-\d\d_\d\d_\d\d', bag.name)
    assert sorted(path.name for path in bag.iterdir()) == ['metadata.yaml', f'{bag.name}.mcap']


def test_bags_of_one_second_do_not_collide(machine, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('time.strftime', lambda form: 'rosbag2_2026_11_22-08_00_00')
    for _ in range(3):
        machine.run('ros2 bag record -a').interrupt()
    assert sorted(path.name for path in machine.folder.iterdir()) == [
        'rosbag2_2026_11_22-08_00_00',
        'rosbag2_2026_11_22-08_00_00_1',
        'rosbag2_2026_11_22-08_00_00_2',
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


def test_record_wants_topics_and_a_new_folder(machine) -> None:
    said = machine.fails('ros2 bag record')
    assert (
        said.startswith('[ERROR] [ros2bag]: Need to specify at least one option out of') and 'write `ros2 bag record -a`' in said
    )
    assert 'record without this option' in machine.fails('ros2 bag record -a --snapshot-mode')
    typed = machine.run('ros2 bag record /one --topics /two')
    assert (typed.code, 'not allowed with argument' in typed.err) == (2, True)
    (machine.folder / 'old').mkdir()
    said = machine.fails('ros2 bag record -a -o old')
    assert "old' already exists.\n" in said and 'help: delete the folder old, or write another name, as in -o old_2' in said


@pytest.mark.parametrize('option', ['--exclude-regex', '-x', '--exclude'])
def test_regex_and_exclude_choose_topics(machine, option: str) -> None:
    typed = machine.run(f'ros2 bag record -e turtle1 {option} color')
    assert [line for line in logged(typed.err) if line.startswith('Subscribed')] == ["Subscribed to topic '/turtle1/pose'"]


def test_play_repeats_what_was_recorded(machine) -> None:
    recorder = machine.start('ros2 bag record -o drive /turtle1/cmd_vel')
    machine.run("ros2 topic pub -t 2 -r 2 /turtle1/cmd_vel geometry_msgs/msg/Twist '{linear: {x: 2}}'", 1.0)
    recorder.interrupt()
    heard = machine.start('ros2 topic echo /turtle1/cmd_vel geometry_msgs/msg/Twist --field linear.x')
    began = machine.now()
    played = machine.run('ros2 bag play drive -r 2', 1.0)
    assert (played.code, heard.writes[0]) == (0, (began, '2.0\n---\n'))
    assert 'Topic: /turtle1/cmd_vel | Type: geometry_msgs/msg/Twist | Count: 1 | ' in machine.read('ros2 bag info drive')
    assert 'ROS Distro:        jazzy\n' in machine.read('ros2 bag info drive')


def test_info_of_no_bag(machine) -> None:
    (machine.folder / 'empty').mkdir()
    assert machine.fails('ros2 bag info empty').startswith("[ERROR] [ros2bag]: 'empty' has no metadata.yaml\n")


@pytest.mark.parametrize('verb', ['info', 'play'])
def test_a_missing_bag_is_a_usage_error(machine, verb: str) -> None:
    typed = machine.run(f'ros2 bag {verb} nix')
    assert typed.code == 2
    assert typed.err.endswith(
        f"ros2 bag {verb}: error: argument bag_path: Bag path 'nix' does not exist!\n"
        '  help: give the folder that `ros2 bag record` created\n'
    )


@pytest.fixture
def bag(machine) -> Any:
    """A bag `drive` with three commands, half a second apart: the first one goes by while the topic is found."""
    recorder = machine.start('ros2 bag record -o drive /turtle1/cmd_vel')
    machine.run("ros2 topic pub -t 4 -r 2 /turtle1/cmd_vel geometry_msgs/msg/Twist '{linear: {x: 2}}'", 2.0)
    recorder.interrupt()
    return machine


def heard(machine, options: str, topic: str = '/turtle1/cmd_vel') -> list[float]:
    """When messages arrive, counted from the start of `ros2 bag play drive OPTIONS`."""
    listener = machine.start(f'ros2 topic echo {topic} geometry_msgs/msg/Twist --field linear.x')
    began = machine.now()
    machine.run(f'ros2 bag play drive {options}', 4.0)
    return [round(time - began, 3) for time, _ in listener.writes]


@pytest.mark.parametrize(
    ('options', 'topic', 'times'),
    [
        ('', '/turtle1/cmd_vel', [0.0, 0.5, 1.0]),
        ('-r 2 --delay 1', '/turtle1/cmd_vel', [1.0, 1.25, 1.5]),
        ('--start-offset 0.3', '/turtle1/cmd_vel', [0.2, 0.7]),
        ('--playback-duration 0.6', '/turtle1/cmd_vel', [0.0, 0.5]),
        ('--remap /turtle1/cmd_vel:=/other', '/other', [0.0, 0.5, 1.0]),
        ('--exclude-topics /turtle1/cmd_vel', '/turtle1/cmd_vel', []),
        ('-e cmd --topics /nothing', '/turtle1/cmd_vel', [0.0, 0.5, 1.0]),
        ('--start-paused', '/turtle1/cmd_vel', []),
    ],
)
def test_play_chooses_topics_names_and_times(bag, options: str, topic: str, times: list[float]) -> None:
    assert heard(bag, options, topic) == times


def test_play_gives_the_time_of_the_bag_out_as_a_clock(bag) -> None:
    clock = bag.start('ros2 topic echo /clock rosgraph_msgs/msg/Clock --field clock')
    bag.run('ros2 bag play drive --clock 10', 2.0)
    times = [int(line.removeprefix('nanosec: ')) for line in clock.out.splitlines() if line.startswith('nanosec')]
    assert len(times) == 11 and {(after - before) % 10**9 for before, after in itertools.pairwise(times)} == {10**8}


def test_space_pauses_and_goes_on(bag) -> None:
    listener = bag.start('ros2 topic echo /turtle1/cmd_vel geometry_msgs/msg/Twist --field linear.x')
    player = bag.start('ros2 bag play drive')
    began = bag.now()
    player.process.streams.stdin = TypedInput([(began + 0.2, ' '), (began + 2.2, ' ')])
    bag.session.run(4.0)
    assert [round(time - began, 1) for time, _ in listener.writes] == [0.0, 2.5, 3.0]
    assert [text for text in logged(player.err) if 'play.' in text] == ['Pausing play.', 'Resuming play.']


INTROSPECTED = """
import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState

def add(request, response):
    print('asked')
    response.sum = request.a + request.b
    return response

rclpy.init()
node = rclpy.create_node('adder')
service = node.create_service(AddTwoInts, 'add_two_ints', add)
service.configure_introspection(node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS)
rclpy.spin(node)
"""


def test_calls_of_a_service_are_recorded_and_made_again(machine) -> None:
    (machine.folder / 'adder.py').write_text(INTROSPECTED)
    server = machine.run('python3 adder.py')
    recorder = machine.run('ros2 bag record -o calls --service /add_two_ints', 0.5)
    machine.run("ros2 service call /add_two_ints example_interfaces/srv/AddTwoInts '{a: 2, b: 3}'", 1.0)
    recorder.interrupt()
    assert 'Service: /add_two_ints | Type: example_interfaces/srv/AddTwoInts | Event Count: 2 | ' in (
        machine.read('ros2 bag info calls')
    )
    verbose = machine.read('ros2 bag info -v -t calls')
    assert verbose.startswith("Warning! You have set both the '-t' and '-v' parameters.")
    assert 'Service: /add_two_ints | Type: example_interfaces/srv/AddTwoInts | Request Count: 1 | Response Count: 1 | ' in verbose
    machine.run('ros2 bag play calls --publish-service-requests', 1.0)
    assert server.out == 'asked\nasked\n'


def test_an_empty_bag_lasts_no_time(machine) -> None:
    machine.run('ros2 bag record -o nothing /nix').interrupt()
    assert 'Duration:          0.000000000s\n' in machine.read('ros2 bag info nothing')


@pytest.mark.parametrize(
    ('rate', 'told'), [('fast', 'fast is not the valid type (float)'), ('0', '0 is not in the valid range (> 0.0)')]
)
def test_a_rate_that_is_none_is_told_as_ros2bag_does(machine, rate: str, told: str) -> None:
    assert machine.run(f'ros2 bag play . -r {rate}').err.endswith(f'error: argument -r/--rate: {told}\n')


def test_the_clock_of_a_playback_runs_as_fast_as_the_playback(bag) -> None:
    """Ten times a second of the simulation, at twice the speed: each step of the clock is 0.2 s of the bag."""
    clock = bag.start('ros2 topic echo /clock rosgraph_msgs/msg/Clock --field clock')
    bag.run('ros2 bag play drive --clock 10 -r 2', 2.0)
    times = [int(line.removeprefix('nanosec: ')) for line in clock.out.splitlines() if line.startswith('nanosec')]
    assert len(times) == 6 and {(after - before) % 10**9 for before, after in itertools.pairwise(times)} == {2 * 10**8}


def test_without_rosbags_the_message_says_which_extra_to_install(machine, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('edulaunch.desk.cli.ros2.bag.find_spec', lambda name: None)
    typed = machine.run('ros2 bag record -a', 0.5)
    assert typed.code == 1
    assert (
        "ros2 bag needs rosbags, which is not installed\n  help: run this in the folder of edulaunch's setup.sh: pip install '.[bags]'"
        in typed.err
    )
    assert list(machine.folder.iterdir()) == []


def topics_of(bag: Path) -> set[str]:
    return {topic for _, topic, _ in read(bag)}


def test_record_with_the_time_of_clock_leaves_out_what_comes_before_it(machine) -> None:
    recorder = machine.start('ros2 bag record --use-sim-time -o timed --topics /turtle1/pose')
    machine.session.run(1.0)
    publish = "ros2 topic pub -r 20 /clock rosgraph_msgs/msg/Clock '{clock: {sec: 77, nanosec: 5}}'"
    machine.run(publish, 1.0)
    recorder.interrupt()
    assert {time for time, _, _ in read(machine.folder / 'timed')} == {77_000_000_005}


def test_record_with_clock_and_without_discovery_is_refused(machine) -> None:
    assert '--use-sim-time and --no-discovery both set' in machine.fails('ros2 bag record -a --use-sim-time --no-discovery')


def test_record_without_keys_and_paused_keeps_nothing(machine) -> None:
    typed = machine.run('ros2 bag record -a -o still --start-paused --disable-keyboard-controls --node-name ear', 1.0)
    assert machine.read('ros2 node list').count('/ear\n') == 1
    typed.interrupt()
    assert 'Press SPACE for pausing/resuming' not in logged(typed.err)
    assert read(machine.folder / 'still') == []


def test_record_leaves_topics_types_and_services_out(machine) -> None:
    machine.run(
        'ros2 bag record -a -o some --exclude-topics /rosout --exclude-topic-types turtlesim/msg/Color '
        '--exclude-services /spawn --ignore-leaf-topics',
        1.0,
    ).interrupt()
    assert topics_of(machine.folder / 'some') == set()
    machine.run('ros2 bag record -a -o more --exclude-topics /rosout --exclude-topic-types turtlesim/msg/Color', 1.0).interrupt()
    assert topics_of(machine.folder / 'more') == {'/turtle1/pose'}


@pytest.mark.parametrize('mode', ['file', 'message'])
def test_a_compressed_bag_can_be_read_and_says_what_it_was_told(machine, mode: str) -> None:
    options = f'--compression-mode {mode} --compression-format zstd --custom-data who=me -b 1000 --log-level error'
    typed = machine.run(f'ros2 bag record -o small --topics /turtle1/pose {options}', 1.0)
    typed.interrupt()
    assert topics_of(machine.folder / 'small') == {'/turtle1/pose'}
    text = (machine.folder / 'small/metadata.yaml').read_text()
    assert 'compression_format: zstd' in text and 'who: me' in text
    assert typed.err == ''


@pytest.mark.parametrize(
    ('options', 'times'),
    [('--playback-until-sec 0.5', []), ('--services /nothing', []), ('--wait-for-all-acked 1 --log-level warn', [0.0, 0.5, 1.0])],
)
def test_play_knows_the_other_options_of_jazzy(bag, options: str, times: list[float]) -> None:
    assert heard(bag, options) == times


def test_info_sorts_by_count(machine) -> None:
    machine.run('ros2 bag record -a -o all', 1.0).interrupt()
    rows = machine.read('ros2 bag info all --sort count')
    counts = [int(row.split('Count: ')[1].split()[0]) for row in rows.splitlines() if 'Count: ' in row]
    assert counts == sorted(counts) and len(set(counts)) > 1
