"""A plain script that sees the real clock runs in real time; whoever cannot see it runs as fast as can be."""

from __future__ import annotations

import datetime
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from greenlet import getcurrent

from edulaunch.engine.processes import current_process
from edulaunch.engine.sim import real_threads
from edulaunch.engine.sim.simulation import EPOCH_NS, Simulation
from edulaunch.engine.sim.task import AmbientTask, current_task
from edulaunch.runtime import ambient
from edulaunch.runtime.ambient import script_sees_the_clock


class World:
    """A real world whose time passes while somebody waits."""

    def __init__(self) -> None:
        self.now_ns = 5 * 10**18

    def monotonic_ns(self) -> int:
        return self.now_ns

    time_ns = monotonic_ns

    def wait(self, seconds: float) -> bool:
        self.now_ns += round(seconds * 1e9)
        return False

    def clear(self) -> None:
        """Nothing was rung."""


@pytest.fixture
def world(monkeypatch: pytest.MonkeyPatch) -> World:
    made = World()
    monkeypatch.setattr(real_threads, 'time', made)
    monkeypatch.setattr(real_threads.threading, 'Event', lambda: made)
    return made


def spun(task: AmbientTask, seconds: float) -> list[float]:
    """When a callback every 0.1 s came, in simulated seconds, while the task waited in pieces of 0.05 s."""
    sim, ticks = task.sim, list[float]()

    def tick(at_ns: int) -> None:
        ticks.append(round((sim.now_ns - began) / 1e9, 2))
        sim.schedule(max(at_ns, sim.now_ns) + 10**8, lambda: tick(at_ns + 10**8))

    began = sim.now_ns
    sim.schedule(began + 10**8, lambda: tick(began + 10**8))
    while sim.now_ns < began + seconds * 1e9:
        task.park(sim.now_ns + 5 * 10**7)
    return ticks


def test_simulated_time_is_real_time(world: World) -> None:
    task = AmbientTask(Simulation())
    task.real_threads = real_threads.RealThreads(task)
    task.real_threads.keep_time()
    assert task.sim.now_ns == world.now_ns
    assert spun(task, 1.0)[:9] == [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]
    assert world.now_ns - 5 * 10**18 == pytest.approx(10**9, abs=6 * 10**7)
    world.now_ns += 10**9  # the script slept
    before = task.sim.now_ns
    task.park(before + 1)
    assert task.sim.now_ns >= before + 10**9


def test_otherwise_no_time_passes_in_the_real_world(world: World) -> None:
    task = AmbientTask(Simulation())
    assert len(spun(task, 1.0)) in (9, 10) and world.now_ns == 5 * 10**18


@pytest.mark.parametrize(
    'names, file, sees',
    [
        ({'time': time}, 'script.py', True),
        ({'now': time.monotonic}, 'script.py', True),
        ({'sleep': time.sleep}, 'script.py', True),
        ({'datetime': datetime.datetime}, 'script.py', True),
        ({'rclpy': sys, 'zero': 0}, 'script.py', False),
        ({'time': time}, pytest.__file__, False),
        ({'time': time}, None, False),
    ],
)
def test_a_script_sees_it_when_its_code_has_a_name_for_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, names: dict[str, Any], file: str | None, sees: bool
) -> None:
    main: Any = ModuleType('__main__')
    if file is not None:
        main.__file__ = str(tmp_path / file)
    monkeypatch.setitem(sys.modules, '__main__', main)
    monkeypatch.delitem(globals(), 'time')  # this file is on the stack, too
    monkeypatch.delitem(globals(), 'datetime')
    here: Any = getcurrent()
    before = here.__dict__.pop('task', None)
    found: dict[str, Any] = {**names, 'ask': script_sees_the_clock, 'process': current_process}
    try:
        exec(compile('sees, start_ns = ask(), process().sim.start_ns', str(tmp_path / 'script.py'), 'exec'), found)
    finally:
        here.task = before if before is not None else AmbientTask(Simulation())
    assert (found['sees'], found['start_ns'] != EPOCH_NS) == (sees, sees)


@pytest.fixture
def script(world: World, monkeypatch: pytest.MonkeyPatch) -> Iterator[AmbientTask]:
    """The task of a plain script in that world, which runs here."""
    monkeypatch.setattr(ambient, 'script_sees_the_clock', lambda: True)
    here: Any = getcurrent()
    before = here.__dict__.pop('task', None)
    task = here.task = AmbientTask(Simulation())
    task.owner = ambient.make_ambient_process(task)
    yield task
    here.task = before if before is not None else AmbientTask(Simulation())


def test_timers_and_stamps_follow_the_wall_while_the_script_is_busy(world: World, script: AmbientTask) -> None:
    import rclpy

    log: list[tuple[float, str]] = []
    began = world.now_ns

    def note(what: str) -> None:
        log.append((round((node.get_clock().now().nanoseconds - began) / 1e9, 2), what))

    rclpy.init(args=[])
    node = rclpy.create_node('busy')
    world.now_ns += 800_000_000  # it computes
    note('computed')
    timer = node.create_timer(0.5, lambda: note('timer'))
    for _ in range(2):
        rclpy.spin_once(node)
    world.now_ns += 300_000_000
    timer.reset()
    rclpy.spin_once(node)
    rclpy.shutdown()
    assert log == [(0.8, 'computed'), (1.3, 'timer'), (1.8, 'timer'), (2.6, 'timer')]


def test_log_lines_follow_the_wall_while_the_script_is_busy(
    world: World, script: AmbientTask, capfd: pytest.CaptureFixture[str]
) -> None:
    import rclpy

    rclpy.init(args=[])
    node = rclpy.create_node('busy')
    began_s = world.now_ns / 1e9
    for number in range(4):
        node.get_logger().info(str(number), throttle_duration_sec=0.5)
        world.now_ns += 300_000_000
    node.get_logger().info('end')
    rclpy.shutdown()
    lines = [line.split() for line in capfd.readouterr().err.splitlines()]
    assert [(round(float(line[1][1:-1]) - began_s, 1), line[3]) for line in lines] == [(0.0, '0'), (0.6, '2'), (1.2, 'end')]


def test_a_lifespan_ends_while_the_script_is_busy(world: World, script: AmbientTask) -> None:
    import rclpy
    from rclpy.duration import Duration
    from rclpy.qos import QoSProfile
    from std_msgs.msg import String

    heard: list[str] = []
    rclpy.init(args=[])
    node = rclpy.create_node('slow')
    qos = QoSProfile(depth=10, lifespan=Duration(seconds=0.5))
    publisher = node.create_publisher(String, 'news', qos)
    node.create_subscription(String, 'news', lambda message: heard.append(message.data), 10)
    world.now_ns += 700_000_000
    publisher.publish(String(data='old'))
    world.now_ns += 600_000_000
    publisher.publish(String(data='new'))
    world.now_ns += 200_000_000
    for _ in range(2):
        rclpy.spin_once(node, timeout_sec=0.01)
    rclpy.shutdown()
    assert heard == ['new']


def run_script(folder: Path, text: str) -> tuple[list[str], int]:
    """The lines that a plain script prints, and its exit code."""
    (folder / 'script.py').write_text(text)
    command = [sys.executable, '-m', 'edulaunch', 'python', 'script.py']
    done = subprocess.run(
        command, cwd=folder, stdout=subprocess.PIPE, text=True, env={**os.environ, 'PYTHONPATH': str(Path.cwd())}
    )
    return done.stdout.splitlines(), done.returncode


SIGNALLED = """
import os, signal, rclpy
from rclpy.executors import ExternalShutdownException
{own}
rclpy.init()
node = rclpy.create_node('node')
node.context.on_shutdown(lambda: print('not called after a signal'))
node.create_timer(0.1, lambda: os.kill(os.getpid(), signal.{number}))
try:
    rclpy.spin(node)
    print('returned')
except (KeyboardInterrupt, ExternalShutdownException) as error:
    print(type(error).__name__)
print(rclpy.ok())
rclpy.uninstall_signal_handlers()
print(signal.getsignal(signal.{number}) in (signal.SIG_DFL, signal.SIG_IGN, signal.default_int_handler, *globals().values()))
"""
OWN = 'def own(*given): print("own handler", len(given))\nsignal.signal(signal.{number}, own)'
IGNORED = 'signal.signal(signal.{number}, signal.SIG_IGN)'


@pytest.mark.processes
@pytest.mark.skipif(os.name == 'nt', reason='no such signals there')
@pytest.mark.parametrize(
    ('number', 'own', 'lines'),
    [
        ('SIGTERM', '', ['returned']),
        ('SIGINT', '', ['KeyboardInterrupt']),
        ('SIGINT', OWN, ['own handler 2', 'returned']),
        ('SIGINT', IGNORED, ['returned']),
    ],
)
def test_a_signal_shuts_rclpy_down_in_a_script(tmp_path: Path, number: str, own: str, lines: list[str]) -> None:
    text = SIGNALLED.format(number=number, own=own.format(number=number))
    assert run_script(tmp_path, text) == ([*lines, 'False', 'True'], 0)


WAITING_CALLBACK = """
import threading, time, rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor

rclpy.init()
node, group, go, done = rclpy.create_node('node'), ReentrantCallbackGroup(), threading.Event(), rclpy.Future()

def wait():
    first.cancel()
    print('waits')
    print(go.wait(20))
    done.set_result(None)

first = node.create_timer(0.1, wait, callback_group=group)
node.create_timer(0.2, go.set, callback_group=group)
executor = MultiThreadedExecutor(2)
executor.add_node(node)
executor.spin_until_future_complete(done)
"""


@pytest.mark.processes
def test_a_callback_that_waits_for_real_does_not_stop_the_others(tmp_path: Path) -> None:
    assert run_script(tmp_path, WAITING_CALLBACK) == (['waits', 'True'], 0)


def test_a_script_has_imported_what_its_interpreter_has(script: AmbientTask) -> None:
    assert [script.owner.has_imported(name) for name in ('time', 'no_such_package')] == [True, False]


def test_a_thread_of_a_script_takes_turns_with_it_in_simulated_time(script: AmbientTask) -> None:
    sim, log = script.sim, list[tuple[float, str]]()
    began = sim.now_ns

    def body() -> None:
        current_task().sleep_until(began + 2 * 10**9)
        log.append((round((sim.now_ns - began) / 1e9, 2), current_task().name))

    thread = script.owner.start_thread(body, 'worker', daemon=True)
    log.append((0.0, thread.name))
    script.sleep_until(began + 3 * 10**9)
    assert log == [(0.0, 'worker'), (2.0, 'worker')] and not thread.is_real_thread


LAUNCHING = """
import os, signal, rclpy
from launch import LaunchDescription, LaunchService
from launch.actions import OpaqueFunction, TimerAction

rclpy.init()
press = OpaqueFunction(function=lambda context: os.kill(os.getpid(), signal.SIGINT))
service = LaunchService(noninteractive=True)
service.include_launch_description(LaunchDescription([TimerAction(period=1.0, actions=[press]), TimerAction(period=60.0, actions=[])]))
print(service.run(), rclpy.ok())
rclpy.shutdown()
"""


@pytest.mark.processes
@pytest.mark.skipif(os.name == 'nt', reason='no such signals there')
def test_launch_in_a_script_that_uses_rclpy_takes_ctrl_c_once(tmp_path: Path) -> None:
    lines, code = run_script(tmp_path, LAUNCHING)
    assert (lines[-1], code) == ('0 True', 0)
    assert [line for line in lines if 'ctrl-c' in line] == ['[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)']
