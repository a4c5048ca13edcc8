"""`ros2 topic ...` in the simulation."""

from __future__ import annotations

import pytest

TWIST = 'geometry_msgs/msg/Twist'
SHOWN = (
    'geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=2.0, y=0.0, z=0.0), '
    'angular=geometry_msgs.msg.Vector3(x=0.0, y=0.0, z=1.8))'
)
POSE = 'x: 5.544444561004639\ny: 5.544444561004639\ntheta: 0.0\nlinear_velocity: 0.0\nangular_velocity: 0.0\n---\n'


def test_list_is_sorted_and_leaves_hidden_topics_out(machine) -> None:
    assert machine.read('ros2 topic list').splitlines() == [
        '/parameter_events',
        '/rosout',
        '/turtle1/cmd_vel',
        '/turtle1/color_sensor',
        '/turtle1/pose',
    ]


def test_list_with_types_and_count(machine) -> None:
    assert '/turtle1/pose [turtlesim/msg/Pose]\n' in machine.read('ros2 topic list -t')
    assert machine.read('ros2 topic list -c') == '5\n'
    assert '/turtle1/rotate_absolute/_action/status\n' in machine.read('ros2 topic list --include-hidden-topics')


def test_verbose_list_tells_the_two_sides(machine) -> None:
    published, subscribed, _ = machine.read('ros2 topic list -v').split('\n\n')
    assert published.startswith('Published topics:\n') and ' * /turtle1/pose [turtlesim/msg/Pose] 1 publisher' in published
    assert f' * /turtle1/cmd_vel [{TWIST}] 1 subscriber' in subscribed.splitlines()


def test_info_counts_both_sides(machine) -> None:
    assert machine.read('ros2 topic info /turtle1/cmd_vel') == f'Type: {TWIST}\nPublisher count: 0\nSubscription count: 1\n'


def test_info_wants_the_full_name_and_names_the_nearest(machine) -> None:
    assert (
        machine.fails('ros2 topic info turtle1/pose') == "Unknown topic 'turtle1/pose'\n  help: did you mean '/turtle1/pose'?\n"
    )


def test_verbose_info_shows_each_endpoint(machine) -> None:
    parts = machine.read('ros2 topic info -v /turtle1/pose').split('\n\n')
    assert parts[:2] == ['Type: turtlesim/msg/Pose', 'Publisher count: 1'] and parts[3] == 'Subscription count: 0'
    assert parts[2].splitlines()[:3] == ['Node name: sim', 'Node namespace: /', 'Topic type: turtlesim/msg/Pose']
    assert '  History (Depth): UNKNOWN' in parts[2].splitlines()


def test_type_and_find(machine) -> None:
    assert machine.read('ros2 topic type /turtle1/pose') == 'turtlesim/msg/Pose\n'
    assert machine.read(f'ros2 topic find {TWIST}') == '/turtle1/cmd_vel\n'
    assert machine.read(f'ros2 topic find -c {TWIST}') == '1\n'
    assert machine.fails('ros2 topic type /nothing') == ''


def test_echo_prints_yaml_and_three_dashes(machine) -> None:
    assert machine.read('ros2 topic echo --once /turtle1/pose') == POSE


def test_echo_takes_relative_names_fields_and_filters(machine) -> None:
    assert machine.read('ros2 topic echo --once turtle1/pose --field theta') == '0.0\n---\n'
    assert machine.read('ros2 topic echo --once turtle1/pose --csv') == '5.544444561004639,5.544444561004639,0.0,0.0,0.0\n'
    assert machine.run('ros2 topic echo turtle1/pose --filter "m.x > 6"').out == ''


def test_echo_of_a_wrong_field_or_filter_says_so(machine) -> None:
    assert 'help: its fields are: x, y, theta' in machine.fails('ros2 topic echo /turtle1/pose --field thet')
    assert machine.fails('ros2 topic echo /turtle1/pose --filter "m.x >"').startswith('Invalid filter expression: m.x >\n')
    assert 'AttributeError' in machine.fails('ros2 topic echo /turtle1/pose --filter "m.z"')


def test_echo_of_an_unknown_topic(machine) -> None:
    assert machine.fails('ros2 topic echo /turtle1/pos') == (
        'WARNING: topic [/turtle1/pos] does not appear to be published yet\n'
        "Could not determine the type for the passed topic\n  help: did you mean '/turtle1/pose'?\n"
    )


def test_echo_gives_up_at_its_timeout(machine) -> None:
    typed = machine.run(f'ros2 topic echo /silent {TWIST} --timeout 0.5', seconds=1)
    assert (typed.code, typed.out, typed.process.returncode) == (0, '', 0)


def test_echo_hears_what_was_published_before_on_a_latched_topic(machine) -> None:
    machine.start('ros2 topic pub -r 0.01 /map std_msgs/msg/Int32 "data: 7" --qos-durability transient_local')
    machine.session.run(0.5)
    assert machine.read('ros2 topic echo --once /map') == 'data: 7\n---\n'


def test_long_arrays_and_strings_are_cut(machine) -> None:
    machine.start('ros2 topic pub /a std_msgs/msg/UInt8MultiArray "data: [1, 2, 3]"')
    assert machine.run('ros2 topic echo --once /a -l 2', 1).out.endswith("data:\n- 1\n- 2\n- '...'\n---\n")
    assert machine.run('ros2 topic echo --once /a --no-arr', 1).out.endswith("data: '<sequence<uint8>, length: 3>'\n---\n")


def test_pub_publishes_at_once_and_then_each_period(machine) -> None:
    typed = machine.run(f"ros2 topic pub -r 2 /turtle1/cmd_vel {TWIST} '{{linear: {{x: 2}}, angular: {{z: 1.8}}}}'", 0.9)
    assert typed.writes == [
        (1.0, 'publisher: beginning loop\n'),
        (1.0, f'publishing #1: {SHOWN}\n\n'),
        (1.5, f'publishing #2: {SHOWN}\n\n'),
    ]


def test_pub_once_waits_for_a_listener_and_stays_a_moment(machine) -> None:
    typed = machine.start('ros2 topic pub --once /late std_msgs/msg/Bool "data: true"')
    machine.session.run(1.3)
    machine.run('ros2 topic echo --once /late std_msgs/msg/Bool')
    assert [time for time, text in typed.writes if text.startswith('Waiting for at least 1')] == [1.0, 2.0]
    assert typed.writes[-1] == (2.4, 'publishing #1: std_msgs.msg.Bool(data=True)\n\n') and typed.code == 0


def test_pub_stamps_headers_at_each_sending(machine) -> None:
    typed = machine.run("ros2 topic pub -t 2 -w 0 -r 4 /r sensor_msgs/msg/TimeReference '{header: auto, time_ref: now}'", 1)
    assert [text.count('nanosec=250000000') for _, text in typed.writes] == [0, 0, 2]


def test_pub_takes_values_behind_options(machine) -> None:
    assert 'data=5' in machine.run('ros2 topic pub /n std_msgs/msg/Int8 -w 0 -t 1 "data: 5"').out


def test_pub_refuses_what_does_not_fit(machine) -> None:
    pub = 'ros2 topic pub /turtle1/cmd_vel'
    assert machine.fails(f'{pub} geometry_msgs/msg/Twis') == (
        "The passed message type is invalid\n  help: did you mean 'geometry_msgs/msg/Twist'?\n"
    )
    assert machine.fails(f'{pub} {TWIST} 5').startswith('The passed value needs to be a dictionary in YAML format\n')
    assert machine.fails(f'{pub} {TWIST} "{{linar: 1}}"') == (
        "Failed to populate field: 'Twist' object has no attribute 'linar'\n  help: did you mean 'linear'?\n"
    )
    assert machine.fails(f'{pub} {TWIST} "{{linear:3}}"').endswith('help: put a space after the colon: linear: 3\n')


@pytest.mark.parametrize('rate', ['nan', 'inf', '0'])
def test_pub_refuses_what_is_no_rate(machine, rate: str) -> None:
    typed = machine.run(f'ros2 topic pub -r {rate} /x std_msgs/msg/Empty')
    assert typed.code == 2 and typed.err.endswith('argument -r/--rate: Value must be positive\n')


def test_pub_gives_up_waiting(machine) -> None:
    typed = machine.run('ros2 topic pub --once --max-wait-time-secs 0.5 /nobody std_msgs/msg/Empty', 1)
    assert (typed.code, typed.err) == (1, 'Timed out waiting for subscribers: Expected 1 subcribers but only got 0 subscribers\n')


def test_hz_reports_each_second(machine) -> None:
    typed = machine.run('ros2 topic hz /turtle1/pose', 2.1)
    line = 'average rate: 62.500\n\tmin: 0.016s max: 0.016s std dev: 0.00000s window: '
    assert typed.writes == [(2.016, f'{line}64\n'), (3.024, f'{line}127\n')]


def test_bw_counts_serialized_bytes(machine) -> None:
    assert machine.run('ros2 topic bw /turtle1/pose', 1.1).out == (
        'Subscribed to [/turtle1/pose]\n1.52 KB/s from 64 messages\n\tMessage size mean: 0.02 KB min: 0.02 KB max: 0.02 KB\n'
    )


def test_delay_measures_the_age_of_stamps(machine) -> None:
    machine.start("ros2 topic pub -r 5 /p geometry_msgs/msg/PointStamped 'header: auto'")
    machine.session.run(0.5)
    typed = machine.run('ros2 topic delay /p', 1.5)
    assert typed.out == 'average delay: 0.000\n\tmin: 0.000s max: 0.000s std dev: 0.00000s window: 6\n'


def test_ctrl_c_ends_a_listener_with_the_number_of_the_signal(machine) -> None:
    typed = machine.run('ros2 topic echo /turtle1/cmd_vel')
    typed.interrupt()
    assert (typed.code, typed.err) == (2, '')


def test_commands_of_the_first_half_second_wait_until_the_graph_is_known(tmp_path) -> None:
    from edulaunch.runtime.session import Session

    session, heard = Session(), []
    from edulaunch.engine.processes.spec import ProcessSpec

    for words in ('ros2 node list', 'ros2 run turtlesim turtlesim_node'):
        session.host.start(ProcessSpec(argv=tuple(words.split())), lambda _, text: heard.append((session.sim.now_ns, text)))
    session.run(1.0)
    session.close()
    assert heard[-1] == (session.sim.start_ns + 500_000_000, '/turtlesim\n')


def test_a_substitution_that_ros_does_not_know_is_an_error_of_one_line(machine) -> None:
    words = machine.fails("ros2 topic pub --once -w 0 '/{}' std_msgs/msg/String '{data: x}'")
    assert words.startswith("topic name '/{}' is invalid: unknown substitution: {}") and 'Traceback' not in words
