"""How late programs were for real, and that a simulation can be made as late."""

from __future__ import annotations

from typing import Any

from edulaunch.comparing.observation import BRIEFLY, Observation, Program
from edulaunch.comparing.pair import delays
from edulaunch.comparing.simulated import simulate


def seen(**parts: Any) -> Observation:
    return Observation(
        **{'nodes': {}, 'ends': {}, 'parameters': {}, 'flows': {}, 'lines': [], 'programs': {}, 'asked_s': 10.0, **parts}
    )


def test_a_program_is_up_when_its_first_node_is_there_or_when_it_has_ended() -> None:
    here = seen(
        nodes={'/a': 1.0, '/b': 1.5, '/brief': BRIEFLY, '/gone': 0.0},
        programs={
            'two_nodes-1': Program(1.0, None, None, frozenset({'/a', '/b'})),
            'command-2': Program(2.0, 2.5, 0),
            'brief-3': Program(0.0, 0.1, 0, frozenset({'/brief'})),
            'never-4': Program(0.0, None, None, frozenset({'/gone'})),
            'early-5': Program(3.0, 4.0, 0),
        },
    )
    there = seen(
        nodes={'/b': 3.75},
        programs={
            'two_nodes-1': Program(1.25),
            'command-2': Program(2.0, 5.5, 0),
            'brief-3': Program(0.0, 2.0, 0),
            'never-4': Program(0.0),
            'early-5': Program(3.0, 3.5, 0),
        },
    )
    assert delays(here, there) == {'two_nodes-1': 2.5, 'command-2': 3.0, 'early-5': 0.0}


def test_programs_that_come_up_late_in_simulation() -> None:
    late = simulate('demo_nodes_cpp', 'talker_listener_launch.py', {}, 6.0, [], {'listener-2': 2.5})
    assert late.nodes == {'/talker': 0.0, '/listener': 2.5}
    heard = [line.time_s for line in late.lines if line.process == 'listener' and 'I heard' in line.text]
    assert heard == [3.0, 4.0, 5.0, 6.0]


def test_ctrl_c_meets_a_program_that_is_not_up_yet() -> None:
    late = simulate('demo_nodes_cpp', 'talker_listener_launch.py', {}, 1.0, [], {'listener-2': 3.0})
    assert late.codes == {'talker': [0], 'listener': [-2]}
    assert late.until_asked().codes == {}
