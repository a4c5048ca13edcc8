"""turtlesim as its neighbours on the graph see it (facts_turtlesim.md)."""

from __future__ import annotations

from typing import Any

import pytest
from geometry_msgs.msg import Twist, Vector3
from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import SetParameters
from std_srvs.srv import Empty
from turtlesim.action import RotateAbsolute
from turtlesim.srv import Kill, SetPen, Spawn, TeleportAbsolute

TICK = 16.0
WRONG_TYPE = 'Wrong parameter type, parameter {background_r} is of type {integer}, setting it to {%s} is not allowed.'


def twist(linear: float, angular: float = 0.0, sideways: float = 0.0) -> Twist:
    return Twist(linear=Vector3(x=linear, y=sideways), angular=Vector3(z=angular))


@pytest.fixture
def sim(stage: Any) -> Any:
    stage.process = stage.start('turtlesim', 'turtlesim_node')
    stage.until(0)
    return stage


def pose_times(stage: Any, turtle: str) -> list[float]:
    return [time for time, _ in stage.tape.published[f'/{turtle}/pose']]


def test_first_lines_are_the_node_and_its_turtle(sim: Any) -> None:
    sim.until(0)
    assert sim.texts() == [
        'Starting turtlesim with node name /turtlesim',
        'Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]',
    ]


def test_poses_come_every_16_ms_from_the_second_tick_on(sim: Any) -> None:
    sim.until(1000)
    assert pose_times(sim, 'turtle1') == [TICK * number for number in range(2, 63)]


def test_endpoints_are_those_of_the_default_node(sim: Any) -> None:
    sim.until(0)
    topics = {e.topic_name for e in sim.graph.nodes[1].endpoints if e.kind in ('publisher', 'subscription')}
    services = {e.service_name for e in sim.graph.nodes[1].endpoints if e.kind == 'service'}
    assert {'/turtle1/pose', '/turtle1/color_sensor', '/turtle1/cmd_vel', '/parameter_events', '/rosout'} <= topics
    assert {
        '/clear',
        '/kill',
        '/reset',
        '/spawn',
        '/turtle1/set_pen',
        '/turtle1/teleport_absolute',
        '/turtle1/teleport_relative',
        '/turtle1/rotate_absolute/_action/send_goal',
    } <= services


def test_one_command_moves_the_turtle_for_63_ticks(sim: Any) -> None:
    sim.until(500)
    sim.publish('/turtle1/cmd_vel', twist(2.0, 1.8))
    sim.until(2000)
    pose = sim.messages('/turtle1/pose')[-1]
    assert (pose.x, pose.y, pose.theta) == (6.602816581726074, 6.938989639282227, 1.8143999576568604)
    assert sum(pose.linear_velocity > 0 for pose in sim.messages('/turtle1/pose')) == 63


def test_one_message_of_a_topic_is_taken_each_tick_and_seven_wait(sim: Any) -> None:
    sim.until(500)
    for number in range(1, 11):
        sim.publish('/turtle1/cmd_vel', twist(float(number)))
    sim.until(500 + 8 * TICK)
    moving = [pose.linear_velocity for pose in sim.messages('/turtle1/pose') if pose.linear_velocity]
    assert moving == [4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 10.0]


def test_sideways_counts_only_when_holonomic(sim: Any) -> None:
    sim.until(100)
    sim.publish('/turtle1/cmd_vel', twist(0.0, sideways=1.0))
    sim.until(200)
    assert sim.messages('/turtle1/pose')[-1].linear_velocity == 0.0
    value = ParameterValue(type=ParameterType.PARAMETER_BOOL, bool_value=True)
    sim.ask('/turtlesim/set_parameters', SetParameters, parameters=[Parameter(name='holonomic', value=value)])
    sim.until(300)
    sim.publish('/turtle1/cmd_vel', twist(0.0, sideways=1.0))
    sim.until(400)
    assert sim.messages('/turtle1/pose')[-1].linear_velocity == 1.0


def test_pushing_a_wall_warns_every_tick(sim: Any) -> None:
    sim.ask('/turtle1/teleport_absolute', TeleportAbsolute, x=11.0, y=1.0, theta=0.0)
    sim.until(100)
    sim.publish('/turtle1/cmd_vel', twist(20.0))
    sim.until(3000)
    walls = [text for text in sim.texts() if 'wall' in text]
    assert len(walls) == 63
    assert walls[0] == 'Oh no! I hit the wall! (Clamping from [x=11.320000, y=10.088889])'


def test_updates_are_in_alphabetical_order(sim: Any) -> None:
    for name in ('turtle2', 'turtle10', 'alf'):
        sim.ask('/spawn', Spawn, x=1.0, y=1.0, name=name)
    sim.until(200)
    numbers = {'/alf/pose': 0, '/turtle1/pose': 0, '/turtle10/pose': 0, '/turtle2/pose': 0}
    order: list[str] = []
    for topic, messages in sim.tape.published.items():
        if topic in numbers:
            messages.clear()
    for publishers in list(sim.graph.publishers.values()):
        for publisher in publishers:
            if publisher.topic_name in numbers:
                publisher.record = lambda record, topic=publisher.topic_name: order.append(topic)
    sim.until(200 + TICK)
    assert order == ['/alf/pose', '/turtle1/pose', '/turtle10/pose', '/turtle2/pose']


def test_spawn_names_turtles_and_answers_a_taken_name_with_nothing(sim: Any) -> None:
    first = sim.ask('/spawn', Spawn, x=2.0, y=2.0, theta=0.2)
    sim.until(20)
    second = sim.ask('/spawn', Spawn, x=2.0, y=2.0, name='turtle2')
    sim.until(40)
    assert [first[0].name, second[0].name] == ['turtle2', '']
    assert sim.texts()[2:] == [
        'Spawning turtle [turtle2] at x=[2.000000], y=[2.000000], theta=[0.200000]',
        'A turtle named [turtle2] already exists',
    ]


def test_kill_takes_the_turtle_off_the_graph(sim: Any) -> None:
    sim.ask('/kill', Kill, name='turtle1')
    sim.until(40)
    sim.ask('/kill', Kill, name='turtle1')
    sim.until(60)
    names = (end.name for end in sim.graph.nodes[1].endpoints)
    assert [name for name in names if 'turtle1' in name] == []
    assert sim.texts()[2:] == ['Tried to kill turtle [turtle1], which does not exist']
    assert sim.process.returncode is None


def test_reset_starts_over_with_turtle1(sim: Any) -> None:
    sim.ask('/spawn', Spawn, x=1.0, y=1.0)
    sim.until(40)
    sim.ask('/reset', Empty)
    sim.until(80)
    assert sim.texts()[3:] == [
        'Resetting turtlesim.',
        'Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]',
    ]
    assert '/turtle2/pose' not in sim.graph.publishers


def test_the_sensor_sees_the_pens_colour_until_clear(sim: Any) -> None:
    sim.ask('/turtle1/set_pen', SetPen, r=255, width=5)
    sim.ask('/turtle1/teleport_absolute', TeleportAbsolute, x=1.0, y=1.0)
    sim.until(100)
    color = sim.messages('/turtle1/color_sensor')[-1]
    assert (color.r, color.g, color.b) == (255, 0, 0)
    sim.ask('/clear', Empty)
    sim.until(140)
    color = sim.messages('/turtle1/color_sensor')[-1]
    assert (color.r, color.g, color.b) == (255, 255, 255)
    assert sim.texts()[-1] == 'Clearing turtlesim.'


@pytest.mark.parametrize(
    'name, value, reason',
    [
        (
            'background_r',
            ParameterValue(type=2, integer_value=256),
            "Parameter {background_r} doesn't comply with integer range.",
        ),
        ('background_r', ParameterValue(type=4, string_value='red'), WRONG_TYPE % 'string'),
        ('x', ParameterValue(type=2, integer_value=1), "parameter 'x' cannot be set because it was not declared"),
        (
            'qos_overrides./parameter_events.publisher.depth',
            ParameterValue(type=2, integer_value=1),
            "parameter 'qos_overrides./parameter_events.publisher.depth' cannot be set because it is read-only",
        ),
    ],
)
def test_parameters_are_refused_in_cpp_words(sim: Any, name: str, value: Any, reason: str) -> None:
    parameter = Parameter(name=name, value=value)
    replies = sim.ask('/turtlesim/set_parameters', SetParameters, parameters=[parameter])
    sim.until(40)
    assert [(result.successful, result.reason) for result in replies[0].results] == [(False, reason)]
    assert sim.process.returncode is None


@pytest.mark.parametrize(
    'value, error',
    [
        ('300', "' could not be set: Parameter {background_r} doesn't comply with integer range."),
        ('1.0', "' has invalid type: " + WRONG_TYPE % 'double'),
    ],
)
def test_a_bad_parameter_at_start_aborts(stage: Any, value: str, error: str) -> None:
    process = stage.start('turtlesim', 'turtlesim_node', '--ros-args', '-p', f'background_r:={value}')
    stage.until(10)
    assert process.returncode == -6
    text = ''.join(text for _, text in stage.tape.outputs)
    assert "terminate called after throwing an instance of 'rclcpp::exceptions::InvalidParameter" in text
    assert f"parameter 'background_r{error}" in text


def test_an_illegal_turtle_name_aborts(sim: Any) -> None:
    sim.ask('/spawn', Spawn, x=1.0, y=1.0, name='my-turtle')
    sim.until(40)
    assert sim.process.returncode == -6
    assert 'rclcpp::exceptions::InvalidTopicNameError' in ''.join(text for _, text in sim.tape.outputs)


def test_ctrl_c_ends_well(sim: Any) -> None:
    sim.until(40)
    sim.process.send_signal(2)
    sim.until(60)
    assert (sim.process.returncode, sim.texts()[-1]) == (0, 'signal_handler(signum=2)')


def test_names_follow_the_namespace(stage: Any) -> None:
    stage.start('turtlesim', 'turtlesim_node', '--ros-args', '-r', '__ns:=/turtlesim1', '-r', '__node:=sim')
    stage.until(40)
    assert stage.texts()[0] == 'Starting turtlesim with node name /turtlesim1/sim'
    assert '/turtlesim1/turtle1/pose' in stage.graph.publishers


def test_mimic_repeats_velocities_at_every_pose(stage: Any) -> None:
    stage.start('turtlesim', 'turtlesim_node', '--ros-args', '-r', '__ns:=/a')
    stage.start('turtlesim', 'turtlesim_node', '--ros-args', '-r', '__ns:=/b')
    stage.start(
        'turtlesim', 'mimic', '--ros-args', '-r', 'input/pose:=/a/turtle1/pose', '-r', 'output/cmd_vel:=/b/turtle1/cmd_vel'
    )
    stage.until(100)
    stage.publish('/a/turtle1/cmd_vel', twist(-1.0, 0.5))
    stage.until(3000)
    assert len(stage.messages('/b/turtle1/cmd_vel')) == len(stage.messages('/a/turtle1/pose'))
    assert max(command.linear.x for command in stage.messages('/b/turtle1/cmd_vel')) == 1.0
    assert stage.messages('/b/turtle1/pose')[-1].theta == pytest.approx(63 * 0.016 * 0.5)


def test_draw_square_turns_left_four_times(sim: Any) -> None:
    sim.start('turtlesim', 'draw_square')
    sim.until(30_000)
    goals = [text for text in sim.texts() if text.startswith('New goal')]
    assert goals[:3] == ['New goal [7.544445 5.544445, 0.000000]', 'New goal [7.544445 5.544445, 1.570796]', goals[2]]
    assert sim.texts().count('Reached goal') == len(goals) - 1 >= 7


def test_draw_square_that_is_there_first_waits_for_turtlesim(stage: Any) -> None:
    stage.start('turtlesim', 'draw_square')
    stage.until(1000)
    stage.start('turtlesim', 'turtlesim_node')
    stage.until(2000)
    assert stage.texts().count('Resetting turtlesim.') == 1
    assert 'New goal [7.544445 5.544445, 0.000000]' in stage.texts()


@pytest.mark.parametrize(
    'keys, linear, angular', [('\x1b[A', 2.0, 0.0), ('\x1b[B', -2.0, 0.0), ('\x1b[C', 0.0, -2.0), ('\x1b[D', 0.0, 2.0)]
)
def test_an_arrow_key_is_one_command(stage: Any, keys: str, linear: float, angular: float) -> None:
    stage.start('turtlesim', 'turtle_teleop_key', stdin=keys)
    stage.until(5000)
    assert [(m.linear.x, m.angular.z) for m in stage.messages('/turtle1/cmd_vel')] == [(linear, angular)]


def test_teleop_rotates_cancels_and_quits(sim: Any) -> None:
    teleop = sim.start('turtlesim', 'turtle_teleop_key', stdin='dxftq')
    sim.until(4000)
    assert sim.texts()[2:] == ['Rotation goal canceled', 'Rotation goal completed successfully']
    assert teleop.returncode == 0
    printed = ''.join(text for _, text in sim.tape.outputs)
    assert f'Reading from keyboard\n{27 * "-"}\nUse arrow keys' in printed


def test_a_newer_goal_and_a_command_abort_the_older(sim: Any) -> None:
    sim.start('turtlesim', 'turtle_teleop_key', stdin='dt')
    sim.until(1100)
    sim.publish('/turtle1/cmd_vel', twist(1.0))
    sim.until(1300)
    assert sim.texts()[2:] == [
        'Rotation goal received before a previous goal finished. Aborting previous goal',
        'Velocity command received during rotation goal. Aborting goal',
    ]
    assert sim.messages('/turtle1/pose')[-1].linear_velocity == 1.0


@pytest.mark.parametrize('theta, count, last, delta', [(1.57, 98, 0.018000006675720215, -1.5520000457763672), (0.0, 1, 0.0, 0.0)])
def test_a_rotation_goal_ends_with_the_golden_feedback_and_result(
    sim: Any, theta: float, count: int, last: float, delta: float
) -> None:
    action = RotateAbsolute.Impl
    goal = RotateAbsolute.Goal(theta=theta)
    accepted = sim.ask('/turtle1/rotate_absolute/_action/send_goal', action.SendGoalService, goal=goal)
    sim.until(100)
    result = sim.ask('/turtle1/rotate_absolute/_action/get_result', action.GetResultService)
    sim.until(3000)
    feedback = [message.feedback.remaining for message in sim.messages('/turtle1/rotate_absolute/_action/feedback')]
    assert accepted[0].accepted
    assert (len(feedback), feedback[-1]) == (count, last)
    assert (result[0].status, result[0].result.delta) == (4, delta)


def test_a_turtle_at_rest_sends_one_and_the_same_pose_until_it_moves(sim: Any) -> None:
    wires: list[Any] = []
    sim.until(100)
    next(iter(sim.graph.publishers['/turtle1/pose'])).record = lambda record: wires.append(record[2])
    sim.until(100 + 3 * TICK)
    assert len({id(wire) for wire in wires}) == 1
    sim.publish('/turtle1/cmd_vel', twist(1.0))
    sim.until(100 + 6 * TICK)
    assert len(set(wires)) == 4


def test_a_sideways_motion_ends_with_a_command_that_names_none(sim: Any) -> None:
    value = ParameterValue(type=ParameterType.PARAMETER_BOOL, bool_value=True)
    sim.ask('/turtlesim/set_parameters', SetParameters, parameters=[Parameter(name='holonomic', value=value)])
    sim.until(100)
    sim.publish('/turtle1/cmd_vel', twist(0.0, sideways=1.0))
    sim.until(200)
    sim.publish('/turtle1/cmd_vel', twist(0.0))
    sim.until(300)
    assert [pose.linear_velocity for pose in sim.messages('/turtle1/pose')][-10::9] == [1.0, 0.0]
