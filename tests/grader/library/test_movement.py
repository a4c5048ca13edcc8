"""Movements are measured from times and positions alone."""

from __future__ import annotations

from typing import Any

import pytest
from edugrade.library.movement import command_topics, distances, farthest, length, pushed
from fake_recording import FakeRecording, process

from edulaunch.engine.recording.records import NodeRecord

LEADER = [(0.0, 0.0, 0.0), (1.0, 3.0, 4.0), (2.0, 3.0, 4.0)]


def test_length_adds_up_the_steps() -> None:
    assert length(LEADER) == 5.0
    assert length([]) == 0.0


def test_distance_is_to_the_newest_sample_of_the_leader() -> None:
    follower = [(0.5, 0.0, 0.0), (1.0, 0.0, 0.0), (3.0, 3.0, 0.0)]
    assert distances(LEADER, follower) == [(0.5, 0.0), (1.0, 5.0), (3.0, 4.0)]


def test_no_distance_before_the_leader_is_there() -> None:
    assert distances(LEADER, [(-1.0, 0.0, 0.0)]) == []


def test_farthest_looks_only_from_its_time_on() -> None:
    samples = [(0.0, 9.0), (1.0, 1.0), (2.0, 2.0)]
    assert farthest(samples, 1.0) == (2.0, 2.0)
    assert farthest(samples, 5.0) is None


def simulator(poses: list[str], commands: list[str]) -> NodeRecord:
    publishers = [('/rosout', 'rcl_interfaces/msg/Log'), *((name, 'turtlesim/msg/Pose') for name in poses)]
    return NodeRecord('/sim', 'sim-1', 0.0, None, publishers, [(name, 'geometry_msgs/msg/Twist') for name in commands], [], [])


def test_a_remapped_turtle_gets_its_velocities_elsewhere() -> None:
    node = simulator(['/turtle1/pose', '/other/pose'], ['/turtle1/cmd_vel', '/hand'])
    run: Any = FakeRecording(processes=[process('turtlesim', 'turtlesim_node', name='sim-1')], nodes=[node])
    assert [command_topics(run, topic) for topic in ('/turtle1/pose', '/other/pose', '/nobody/pose')] == [
        {'/turtle1/cmd_vel'},
        {'/hand'},
        set(),
    ]


class Rows:
    """A recording with poses and velocities."""

    def __init__(self, rows: list[tuple[float, float, float, float]]) -> None:
        self.rows = rows

    def series(self, topic: str, *fields: str) -> list[tuple[float, float, float, float]]:
        return self.rows


def test_a_teleported_turtle_moves_without_a_velocity() -> None:
    driven = [(0.0, 5.0, 5.0, 0.0), (0.1, 5.1, 5.0, 1.0), (0.2, 5.2, 5.0, 1.0)]
    still: Any = Rows(driven)
    assert pushed(still, '/turtle1/pose') == 0.0
    in_steps = [(step / 10, 5.0 + 0.01 * step, 5.0, 0.0) for step in range(21)]
    carried: Any = Rows(in_steps)
    assert pushed(carried, '/turtle1/pose') == pytest.approx(0.2)
