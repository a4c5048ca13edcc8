"""rclpy.timer: the grid of calls, and rates."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
import rclpy
from hypothesis import given
from hypothesis import strategies as st
from rclpy._rclpy_pybind11 import InvalidHandle, RCLError
from rclpy.exceptions import ROSInterruptException
from rclpy.node import Node

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.sync import sleep

from .conftest import Ros, World


def spin_for(seconds: float, node: Node) -> None:
    node.create_timer(seconds, rclpy.shutdown)
    rclpy.spin(node)


def test_the_first_call_is_one_period_after_creation(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        node.create_timer(0.3, lambda: world.say('tick'))
        spin_for(1.0, node)

    world.start(program)
    assert world.run() == [(300.0, 'main', 'tick'), (600.0, 'main', 'tick'), (900.0, 'main', 'tick')]


def test_periods_are_whole_nanoseconds(ros: Callable[..., list[Any]], world: World) -> None:
    assert ros(lambda: world.say(Node('n').create_timer(1 / 3, None).timer_period_ns)) == [333_333_333]


def test_a_period_fits_into_64_bits(ros: Ros, world: World) -> None:
    def body() -> None:
        with pytest.raises(TypeError, match=r'__init__\(\): incompatible constructor arguments'):
            Node('n').create_timer(1e12, print)
        world.say('refused')

    assert ros(body) == ['refused']


def test_missed_calls_are_skipped_not_made_up_for(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        naps = iter([0.25])

        def tick() -> None:
            world.say('tick')
            sleep(next(naps, 0))

        node.create_timer(0.1, tick)
        spin_for(0.65, node)

    world.start(program)
    assert [at for at, _, _ in world.run()] == [100.0, 350.0, 400.0, 500.0, 600.0]


@given(st.integers(1, 50), st.lists(st.integers(0, 500), max_size=5))
def test_calls_stay_on_the_grid_however_long_they_take(period_ms: int, naps_ms: list[int]) -> None:
    world = World()

    def program() -> None:
        rclpy.init()
        node = Node('n')
        naps = iter(naps_ms)

        def tick() -> None:
            world.say('tick')
            sleep(next(naps, 0) / 1000)

        node.create_timer(period_ms / 1000, tick)
        rclpy.spin(node)

    world.start(program)
    times = [round(at * 1e6) for at, _, _ in world.run(1)]
    period = int(period_ms / 1000 * 1e9)
    assert times[0] == period
    late_by = [at % period for at, nap in zip(times[1:], naps_ms, strict=False) if nap == 0]
    assert not any(late_by[1:2])
    assert all(at % period == 0 for at in times[len(naps_ms) + 1 :])


def test_a_cancelled_timer_is_silent_until_it_is_reset(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        timer = node.create_timer(0.2, lambda: world.say('tick'))
        timer.cancel()
        world.say((timer.is_canceled(), timer.time_until_next_call()))
        node.create_timer(0.5, timer.reset)
        spin_for(0.95, node)

    world.start(program)
    assert world.run() == [(0.0, 'main', (True, None)), (700.0, 'main', 'tick'), (900.0, 'main', 'tick')]


def test_autostart_false_begins_cancelled(ros: Callable[..., list[Any]], world: World) -> None:
    ros(lambda: world.say(Node('n').create_timer(1.0, None, autostart=False).is_canceled()))
    assert [what for _, _, what in world.log] == [True]


def test_a_new_period_counts_after_the_next_call(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        timer = node.create_timer(0.1, lambda: world.say('tick'))
        timer.timer_period_ns = 400_000_000
        spin_for(1.0, node)

    world.start(program)
    assert [at for at, _, _ in world.run()] == [100.0, 500.0, 900.0]


def test_a_timer_without_period_is_always_ready_but_time_passes(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        calls = []
        node.create_timer(0, lambda: calls.append(1))
        spin_for(0.01, node)
        world.say(len(calls) > 500)

    assert world.run_program(program) == [True]


def test_a_negative_period_is_refused(ros: Callable[..., list[Any]], world: World) -> None:
    def body() -> None:
        with pytest.raises(RCLError, match='timer period must be non-negative'):
            Node('n').create_timer(-1.0, None)
        world.say('refused')

    assert ros(body) == ['refused']


def test_a_destroyed_timer_cannot_be_used(ros: Callable[..., list[Any]], world: World) -> None:
    def body() -> None:
        node = Node('n')
        timer = node.create_timer(1.0, None)
        assert node.destroy_timer(timer)
        assert not node.destroy_timer(timer)
        with pytest.raises(InvalidHandle):
            timer.reset()
        world.say(list(node.timers))

    assert ros(body) == [[]]


def test_time_until_and_since_calls(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        timer = node.create_timer(1.0, None)
        sleep(0.25)
        world.say((timer.time_until_next_call(), timer.time_since_last_call(), timer.is_ready()))
        sleep(1.0)
        world.say((timer.time_until_next_call(), timer.is_ready()))

    assert world.run_program(program) == [(750_000_000, 250_000_000, False), (-250_000_000, True)]


def test_a_rate_sleeps_on_its_grid_while_another_thread_spins(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        current_process().start_thread(lambda: rclpy.spin(node), 'spinner', True)
        rate = node.create_rate(4)
        for _ in range(3):
            rate.sleep()
            world.say('awake')

    world.start(program)
    assert [at for at, _, _ in world.run()] == [250.0, 500.0, 750.0]


def test_a_call_while_nobody_slept_ends_the_next_sleep_at_once(world: World) -> None:
    """Measured with rclpy 7.1.6."""

    def program() -> None:
        rclpy.init()
        node = Node('n')
        current_process().start_thread(lambda: rclpy.spin(node), 'spinner', True)
        rate = node.create_rate(2)
        for pause_s in (1.2, 0.0, 0.9, 0.0):
            sleep(pause_s)
            rate.sleep()
            world.say('awake')

    world.start(program)
    assert [at for at, _, _ in world.run()] == [1200.0, 1500.0, 2400.0, 2500.0]


def test_a_timer_without_a_function_ends_the_program_when_it_is_due(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        node.create_timer(1.0, None)
        with pytest.raises(TypeError, match="'NoneType' object is not callable"):
            rclpy.spin(node)
        world.say('over')

    world.start(program)
    assert world.run(3) == [(1000.0, 'main', 'over')]


def test_a_sleeping_rate_is_interrupted_by_shutdown(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        node.create_timer(0.1, rclpy.shutdown)
        current_process().start_thread(lambda: rclpy.spin(node), 'spinner', True)
        with pytest.raises(ROSInterruptException, match=r'rclpy.shutdown\(\) has been called'):
            node.create_rate(1).sleep()
        world.say('interrupted')

    world.start(program)
    assert world.run() == [(100.0, 'main', 'interrupted')]


def test_a_rate_inside_a_callback_is_explained(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        rate = node.create_rate(10)
        node.create_timer(0.05, rate.sleep)
        rclpy.spin(node)

    world.start(program)
    world.run(1)
    assert [(kind, data['callback']) for kind, data in world.tracer.facts] == [('rate in callback', 'sleep')]


def test_rates_must_be_positive(ros: Callable[..., list[Any]], world: World) -> None:
    def body() -> None:
        with pytest.raises(ValueError, match='frequency must be > 0'):
            Node('n').create_rate(0)
        world.say('refused')

    assert ros(body) == ['refused']


def test_a_rate_that_is_destroyed_wakes_and_sleeps_no_more(ros: Callable[..., list[Any]], world: World) -> None:
    def body() -> None:
        node = Node('n')
        rate = node.create_rate(1)
        node.create_timer(0.2, lambda: node.destroy_rate(rate))
        current_process().start_thread(lambda: rclpy.spin(node), 'spin', True)
        world.say(rate.sleep())
        with pytest.raises(RuntimeError, match='Rate cannot sleep because it has been destroyed'):
            rate.sleep()

    assert ros(body) == [None]
