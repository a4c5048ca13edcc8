"""How late programs were for real, and that a simulation can be made as late."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from edulaunch.extras.comparing import pair
from edulaunch.extras.comparing.observation import BRIEFLY, Observation, Program
from edulaunch.extras.comparing.pair import delays
from edulaunch.extras.comparing.simulated import simulate


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


def test_a_program_that_a_signal_ended_first_never_came_to_its_end() -> None:
    here = seen(programs={'echo-1': Program(0.0, 1.0, 0)})
    assert delays(here, seen(programs={'echo-1': Program(0.5, 6.0, -2, signalled_s=5.5)})) == {'echo-1': 9.5}
    assert delays(here, seen(programs={'echo-1': Program(0.5, 5.0, 0, signalled_s=5.5)})) == {'echo-1': 3.5}


DICE = """
import random, time
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64

class Dice(Node):
    def __init__(self):
        super().__init__('dice')
        self.declare_parameter('sides', SIDES)
        self.number = self.create_publisher(Float64, 'number', 10)
        self.hour = self.create_publisher(Float64, 'day', 10)
        self.thrown = 1000 * random.random()
        self.create_timer(0.5, self.tick)

    def tick(self):
        self.number.publish(Float64(data=self.thrown))
        self.hour.publish(Float64(data=time.time() // 86400))

rclpy.init()
rclpy.spin(Dice())
"""
OTHER_DAY_S = 1_800_000_000.0


@pytest.mark.parametrize(('sides', 'found'), [(6, []), (8, [('parameter', 'sides of /dice', '6', '8')])])
def test_random_numbers_and_the_time_of_day_are_no_difference(
    sides: int, found: list[tuple[str, ...]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In place of the run for real another simulation, of other random numbers and on another day."""
    program, file = tmp_path / 'dice.py', tmp_path / 'x.launch.xml'
    file.write_text(f'<launch><executable cmd="python3 {program}" name="dice"/></launch>')

    def real(path: str, *what: Any) -> Observation:
        program.write_text(DICE.replace('SIDES', str(sides)))
        made = simulate(path, None, {}, 6.0, [], None, OTHER_DAY_S, 7)._replace(start_s=OTHER_DAY_S)
        program.write_text(DICE.replace('SIDES', '6'))
        return made

    monkeypatch.setattr(pair, 'run_for_real', real)
    program.write_text(DICE.replace('SIDES', '6'))
    compared = pair.compare(str(file), None, {}, 6.0)
    assert [each[:4] for each in compared.found] == found
    assert [each.name for each in compared.chance] == ['/number data']


MAKER = """
import os
os.mkdir('made')
print('made in', os.getcwd())
"""


def test_no_run_finds_what_another_one_left(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'maker.py').write_text(MAKER)
    (tmp_path / 'x.launch.xml').write_text('<launch><executable cmd="python3 maker.py" output="screen"/></launch>')
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(pair, 'run_for_real', lambda *what: simulate(*what[:5]))
    compared = pair.compare('x.launch.xml', None, {}, 6.0)
    assert compared.found == []
    assert [line.text for line in compared.real.lines][0].startswith('made in ')
    assert sorted(path.name for path in tmp_path.iterdir()) == ['maker.py', 'x.launch.xml']
