"""A machine of one's own: time by hand, commands, going back, and the end."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator

import pytest

import edulaunch
from edulaunch import UnusableInput
from edulaunch.desk.machine.started import Machine
from edulaunch.desk.view.replay import RecorderSource
from edulaunch.desk.view.timeline import Timeline


@pytest.fixture
def machine() -> Iterator[Machine]:
    with edulaunch.start('turtlesim', 'multisim.launch.py') as machine:
        yield machine


def test_time_passes_when_it_is_told_to_and_stands_still_between(machine: Machine) -> None:
    assert machine.run(1.5).duration_s == 1.5
    assert machine.recording().duration_s == 1.5


def test_a_tick_is_sixteen_milliseconds(machine: Machine) -> None:
    machine.run(1)
    machine.step()
    assert machine.recording().duration_s == pytest.approx(1.016, abs=1e-9)
    assert machine.time.paused


def test_a_command_runs_on_it(machine: Machine) -> None:
    machine.run(1)
    assert machine.ros2('node list') == '/turtlesim1/turtlesim\n/turtlesim2/turtlesim\n'


def test_going_on_from_an_instant_repeats_what_was_until_then_and_forgets_what_came_after(machine: Machine) -> None:
    machine.run(1)
    machine.take({'op': 'drive', 'turtle': '/turtlesim1/turtle1', 'linear': 2, 'angular': 1})
    machine.run(1)
    machine.take({'op': 'drive', 'turtle': '/turtlesim1/turtle1', 'linear': -2, 'angular': 0})
    before = machine.run(1).trajectory('/turtlesim1/turtle1')
    machine.continue_at(1.8)
    again = machine.recording()
    assert again.duration_s == pytest.approx(1.8)
    rows = again.trajectory('/turtlesim1/turtle1')
    count = len(rows.t)
    assert count > 100
    assert [list(column) for column in rows] == [list(column[:count]) for column in before]
    assert len(again.messages('/turtlesim1/turtle1/cmd_vel')) == 1
    onwards = machine.run(1.2).trajectory('/turtlesim1/turtle1')
    assert onwards.x[-1] != before.x[-1]  # nobody drives back this time


def test_what_was_done_by_hand_is_repeated_each_time(machine: Machine) -> None:
    machine.run(1)
    machine.take({'op': 'drive', 'turtle': '/turtlesim1/turtle1', 'linear': 2, 'angular': 1})
    machine.run(1)
    digests = []
    for _ in range(2):
        machine.continue_at(1.5)
        digests.append(machine.recording().digest())
    assert digests[0] == digests[1]


def test_it_follows_the_clock_beside_other_tasks_and_leaves_nothing_behind() -> None:
    async def body() -> tuple[float, int]:
        with edulaunch.start('turtlesim', 'multisim.launch.py', speed=20) as machine:
            while machine.session.sim.elapsed_s < 1:
                await asyncio.sleep(0)
        return machine.session.sim.elapsed_s, len(asyncio.all_tasks())

    elapsed_s, tasks = asyncio.run(body())
    assert elapsed_s >= 1
    assert tasks <= 2  # this one, and the one that is being cancelled


@pytest.mark.parametrize(('speed', 'tab', 'step'), [(0, 'graph', 'tick'), (1, 'grahp', 'tick'), (1, 'graph', 'hour')])
def test_what_is_not_there_is_named(speed: float, tab: str, step: str) -> None:
    with pytest.raises(UnusableInput), edulaunch.start(speed=speed) as machine:
        machine.step(step)
        machine.view(tab)


def test_a_machine_that_goes_on_for_long_lets_old_messages_go_and_says_from_where_it_has_them() -> None:
    with edulaunch.start('turtlesim', 'multisim.launch.py', keep_s=20) as machine:
        timeline = Timeline(RecorderSource(machine.session.recorder))
        counts = []
        for _ in range(6):
            recording = machine.run(20)
            timeline.delta()
            counts.append(sum(topic.count for topic in recording.topics.values()))
        assert recording.duration_s == 120 and recording.trajectory('/turtlesim1/turtle1').t[0] == pytest.approx(100, abs=0.1)
        assert counts[-1] <= counts[1] * 1.1
        assert [row[2] for row in recording._content['endpoints']], 'the graph stays whole'


def test_without_a_limit_everything_stays() -> None:
    with edulaunch.start('turtlesim', 'multisim.launch.py', keep_s=None) as machine:
        assert machine.run(40).trajectory('/turtlesim1/turtle1').t[0] < 0.1
