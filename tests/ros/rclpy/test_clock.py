"""rclpy.clock, and use_sim_time."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import rclpy
from builtin_interfaces.msg import Time as TimeMessage
from rclpy._rclpy_pybind11 import RCLError
from rclpy.clock import Clock, ClockChange, ClockType, JumpThreshold, ROSClock
from rclpy.duration import Duration
from rclpy.exceptions import NotInitializedException
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.time import Time
from rosgraph_msgs.msg import Clock as ClockMessage

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.sync import sleep

from .conftest import Ros, World


def clock_publisher(*seconds: int) -> Callable[[], None]:
    """A program that says on /clock what time it is, each 0.1 s."""

    def program() -> None:
        rclpy.init()
        publisher = Node('clock').create_publisher(ClockMessage, '/clock', 10)
        for second in seconds:
            sleep(0.1)
            publisher.publish(ClockMessage(clock=TimeMessage(sec=second)))

    return program


@pytest.mark.parametrize('clock_type', [ClockType.SYSTEM_TIME, ClockType.STEADY_TIME, ClockType.ROS_TIME])
def test_every_clock_tells_simulated_time(ros: Ros, world: World, clock_type: ClockType) -> None:
    def body() -> None:
        clock = Clock(clock_type=clock_type)
        sleep(2)
        now = clock.now()
        world.say((now.nanoseconds - world.sim.start_ns, now.clock_type == clock_type, type(clock) is ROSClock))

    assert ros(body) == [(2_000_000_000, True, clock_type is ClockType.ROS_TIME)]


def test_sleeping_on_a_clock(world: World) -> None:
    def program() -> None:
        rclpy.init()
        clock = Clock()
        world.say(clock.sleep_for(Duration(seconds=0.5)))
        current_process().start_thread(lambda: (sleep(0.25), rclpy.shutdown()), 'other', True)
        world.say(clock.sleep_for(Duration(seconds=0.5)))
        with pytest.raises(NotInitializedException):
            clock.sleep_for(Duration(seconds=1))

    world.start(program)
    assert world.run(2) == [(500.0, 'main', True), (750.0, 'main', False)]


def test_sleep_until_wants_a_time_of_its_own_clock(ros: Ros, world: World) -> None:
    def body() -> None:
        with pytest.raises(ValueError, match="until's clock type does not match this clock's type"):
            Clock().sleep_until(Time(clock_type=ClockType.ROS_TIME))
        world.say('refused')

    assert ros(body) == ['refused']


def test_with_use_sim_time_the_clock_follows_the_topic_from_zero(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n', parameter_overrides=[Parameter('use_sim_time', value=True)])
        clock = node.get_clock()
        world.say(clock.now().nanoseconds)
        for _ in range(2):
            rclpy.spin_once(node)
            world.say(clock.now().nanoseconds // 10**9)
        node.set_parameters([Parameter('use_sim_time', value=False)])
        world.say(clock.now().nanoseconds == world.sim.now_ns)

    world.start(clock_publisher(5, 7), name='clock')
    assert world.run_program(program) == [0, 5, 7, True]


def test_timers_go_by_the_topic_and_jump_once(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n', parameter_overrides=[Parameter('use_sim_time', value=True)])
        node.create_timer(0.7, lambda: world.say(node.get_clock().now().nanoseconds // 10**9))
        rclpy.spin(node)

    world.start(program)
    world.start(clock_publisher(1, 1, 5, 2, 3), name='clock')
    assert [(at, what) for at, _, what in world.run(1)] == [(100.0, 1), (300.0, 5), (500.0, 3)]


def test_what_clock_told_last_outlives_its_rule(ros: Ros, world: World) -> None:
    def body() -> None:
        clock = ROSClock()
        clock.set_ros_time_override(Time(seconds=7, clock_type=ClockType.ROS_TIME))
        for active in (True, False, True):
            clock._set_ros_time_is_active(active)
            world.say(clock.now().nanoseconds == 7 * 10**9)

    assert ros(body) == [True, False, True]


def test_a_jump_onto_the_grid_calls_a_timer_once(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        clock = node.get_clock()
        clock._set_ros_time_is_active(True)
        timer = node.create_timer(1.0, lambda: world.say(timer.time_until_next_call()))
        for second in (1, 4, 4.5):
            clock.set_ros_time_override(Time(seconds=second, clock_type=ClockType.ROS_TIME))
            for _ in range(2):
                rclpy.spin_once(node, timeout_sec=0.1)

    assert ros(body) == [10**9, 10**9]


def test_a_new_time_source_swaps_what_a_timer_has_waited_and_has_to_wait(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        clock = node.get_clock()
        clock.set_ros_time_override(Time(seconds=100, clock_type=ClockType.ROS_TIME))
        timer = node.create_timer(1.0, lambda: None)
        sleep(0.3)
        for active in (True, False):
            clock._set_ros_time_is_active(active)
            world.say((timer.time_since_last_call() // 10**6, timer.time_until_next_call() // 10**6))

    assert ros(body) == [(700, 300), (300, 700)]


def test_a_sleep_until_a_time_that_is_over_ends_with_the_next_message_of_clock(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n', parameter_overrides=[Parameter('use_sim_time', value=True)])
        current_process().start_thread(lambda: rclpy.spin(node), 'other', True)
        sleep(0.15)
        world.say(node.get_clock().now().nanoseconds // 10**9)
        world.say(node.get_clock().sleep_until(Time(seconds=3, clock_type=ClockType.ROS_TIME)))

    world.start(program)
    world.start(clock_publisher(5, 7), name='clock')
    assert [(at, what) for at, _, what in world.run(1)] == [(150.0, 5), (200.0, True)]


def test_use_sim_time_must_be_a_bool(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node._rclpy.parameters.descriptors['use_sim_time'].dynamic_typing = True
        world.say(node.set_parameters([Parameter('use_sim_time', value=1)])[0].reason)

    assert ros(body) == ['use_sim_time parameter set to something besides a bool']


def test_jump_callbacks_are_told_what_they_asked_for(ros: Ros, world: World) -> None:
    def body() -> None:
        clock = ROSClock()
        threshold = JumpThreshold(min_forward=Duration(seconds=2), min_backward=Duration(seconds=-1))
        handle = clock.create_jump_callback(
            threshold,
            post_callback=lambda jump: world.say(
                (
                    jump.clock_change,
                    jump.delta.nanoseconds // 10**9 if jump.clock_change == ClockChange.ROS_TIME_NO_CHANGE else None,
                )
            ),
        )
        clock._set_ros_time_is_active(True)
        for second in (1, 4, 3, 3):
            clock.set_ros_time_override(Time(seconds=second, clock_type=ClockType.ROS_TIME))
        handle.unregister()
        clock._set_ros_time_is_active(False)

    assert ros(body) == [
        (ClockChange.ROS_TIME_ACTIVATED, None),
        (ClockChange.ROS_TIME_NO_CHANGE, 3),
        (ClockChange.ROS_TIME_NO_CHANGE, -1),
    ]


def test_a_callback_is_given_the_change_as_cpp_prints_it(ros: Ros, world: World) -> None:
    def program() -> None:
        rclpy.init()
        clock = ROSClock()
        clock._set_ros_time_is_active(True)
        threshold = JumpThreshold(min_forward=Duration(seconds=1), min_backward=None)
        handle = clock.create_jump_callback(threshold, post_callback=lambda jump: world.say(str(jump.clock_change)))
        clock.set_ros_time_override(Time(seconds=5, clock_type=ClockType.ROS_TIME))
        handle.unregister()
        with pytest.raises(AttributeError, match="'int' object has no attribute 'min_forward'"):
            clock.create_jump_callback(3, post_callback=print)
        world.say(str(ClockChange.ROS_TIME_NO_CHANGE))

    world.start(program)
    assert [text for _, _, text in world.run(0.1)] == ['ClockChange.ROS_TIME_NO_CHANGE', '1']


def test_jump_thresholds_have_a_sign() -> None:
    with pytest.raises(ValueError, match='min_forward must be a positive non-zero duration'):
        JumpThreshold(min_forward=Duration(), min_backward=None)
    with pytest.raises(ValueError, match='min_backward must be a negative non-zero duration'):
        JumpThreshold(min_forward=None, min_backward=Duration())


def test_the_type_of_a_time_prints_as_in_ros_2_and_can_be_used_again() -> None:
    kind = Time(clock_type=ClockType.ROS_TIME).clock_type
    assert (str(kind), f'{kind}', repr(kind)) == ('ClockType.ROS_TIME', 'ClockType.ROS_TIME', '<ClockType.ROS_TIME: 1>')
    assert kind == ClockType.ROS_TIME and kind == ClockType.ROS_TIME and hash(kind) == hash(ClockType.ROS_TIME)
    assert str(ClockType.ROS_TIME) == str(Clock(clock_type=kind).clock_type) == '1'
    assert Time(clock_type=kind) == Time(clock_type=ClockType.ROS_TIME) and isinstance(Clock(clock_type=kind), ROSClock)


def test_a_clock_of_no_type_has_no_time() -> None:
    with pytest.raises(RCLError, match=r'^failed to get current clock value: Clock is not initialized or'):
        Clock(clock_type=ClockType.UNINITIALIZED).now()


def test_a_change_of_the_source_prints_as_its_number() -> None:
    assert (str(ClockChange.ROS_TIME_ACTIVATED), f'{ClockChange.SYSTEM_TIME_NO_CHANGE}') == ('2', '4')
