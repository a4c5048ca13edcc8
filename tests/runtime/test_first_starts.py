"""A program whose first start fails: the second one works, and other programs do not wait for it."""

from __future__ import annotations

from edulaunch.runtime.first_starts import FirstStarts


def test_only_the_first_start_fails() -> None:
    host = FirstStarts()
    host.fails = ['turtlesim_node', 'ros2 bag record']
    assert host.refused_now('ros2 bag record -a') == 'ros2 bag record'
    assert [host.refuses('ros2 bag record -a') for _ in range(2)] == [True, False]
    assert host.fails == ['turtlesim_node']


def test_a_name_that_only_begins_alike_is_another_program() -> None:
    host = FirstStarts()
    host.fails = ['turtlesim_node']
    assert not host.refuses('turtlesim_node_2')
    assert host.refuses('turtlesim_node')
