"""What the rubric of large_project says of made-up runs."""

from __future__ import annotations

from typing import Any

from edugrade import Scenario
from fake_recording import graded
from fake_runs import FakeRun, frame, mimic, node, program, statuses

from edulaunch.engine.recording.records import Parameter, TopicRecord

WORLD = program(1, 'turtlesim', 'turtlesim_node')
LISTENER = program(2, 'turtle_tf2_py', 'turtle_tf2_listener')
MIMIC = program(3, 'turtlesim', 'mimic')
COPIES = mimic(MIMIC, '/turtle2', '/turtlesim2/turtle1')
WATER = {
    f'background_{letter}': Parameter(value, 'turtlesim.yaml line 4') for letter, value in zip('rgb', (150, 86, 255), strict=True)
}
POSES = {'/turtle2/pose': TopicRecord('/turtle2/pose', 't', ['/sim'], ['/mimic'], 1)}
PLACES = {'carrot1': (5.5, 7.5), 'turtle1': (5.5, 5.5)}


def run(scenario: Scenario, **changes: Any) -> FakeRun:
    goal = scenario.arguments['goal']
    x, y = PLACES[goal]
    way = [(0.0, 4.0, 2.0), (5.0, x, y), (19.0, x, y)]
    return FakeRun(
        **{
            'processes': [WORLD, LISTENER, MIMIC],
            'nodes': [node('/sim', WORLD), node('/turtlesim2/sim', WORLD), node('/listener', LISTENER), COPIES],
            'values': {'/sim': WATER, '/turtlesim2/sim': WATER, '/listener': {'target_frame': Parameter(goal, 'x')}},
            'frames': lambda time_s: {'turtle1': frame('world', 5.5, 5.5), 'carrot1': frame('turtle1', 0.0, 2.0)},
            'tracks': {'/turtle2/pose': way, '/turtlesim2/turtle1/pose': way},
            'topics': {
                '/turtlesim2/turtle1/cmd_vel': TopicRecord('/turtlesim2/turtle1/cmd_vel', 't', ['/mimic'], ['/sim'], 1),
                **POSES,
            },
            **changes,
        }
    )


def test_a_correct_launch_passes_everything() -> None:
    results = graded('large_project', run)
    assert statuses(results) == {}
    assert sum(result.earned for result in results.values()) == 12


def test_without_the_pushed_namespace_the_rest_of_the_second_world_is_not_judged() -> None:
    results = graded('large_project', lambda s: run(s, nodes=[node('/sim', WORLD), node('/listener', LISTENER)]))
    assert results['second_world_is_there'].seen == '/sim'
    assert statuses(results) == {
        'second_world_is_there': 'failed',
        'water_comes_from_the_file': 'not_run',
        'mimic_copies': 'not_run',
    }


def test_a_mimic_called_sim_is_no_second_world() -> None:
    nodes = [node('/sim', WORLD), node('/turtlesim2/sim', MIMIC), node('/listener', LISTENER), COPIES]
    results = graded('large_project', lambda s: run(s, nodes=nodes))
    assert results['second_world_is_there'].status == 'failed'


def test_water_that_is_the_default_is_shown_with_its_origin() -> None:
    plain = {name: Parameter(69, 'default') for name in WATER}
    results = graded('large_project', lambda s: run(s, values={**run(s).values, '/turtlesim2/sim': plain}))
    assert statuses(results) == {'water_comes_from_the_file': 'failed'}
    assert results['water_comes_from_the_file'].reason.endswith('of /turtlesim2/sim should come from config/turtlesim.yaml')
    assert 'background_r is 69, the default value' in results['water_comes_from_the_file'].seen


def test_the_right_colours_from_elsewhere_are_not_those_of_the_file() -> None:
    written = {name: parameter._replace(origin='world.launch.py line 3') for name, parameter in WATER.items()}
    results = graded('large_project', lambda s: run(s, values={**run(s).values, '/sim': written}))
    assert statuses(results) == {'water_comes_from_the_file': 'failed'}


def test_a_goal_that_is_not_passed_on_shows_both_runs() -> None:
    values = {'/sim': WATER, '/turtlesim2/sim': WATER, '/listener': {'target_frame': Parameter('turtle1', 'default')}}
    results = graded('large_project', lambda s: run(s, values=values))
    assert results['goal_is_passed_on'].expected == 'carrot1 with goal:=carrot1\nturtle1 with goal:=turtle1'
    assert statuses(results) == {'goal_is_passed_on': 'failed', 'goal_is_reached': 'not_run'}


def test_a_turtle_that_copies_nobody_is_measured() -> None:
    results = graded('large_project', lambda s: run(s, tracks={'/turtle2/pose': run(s).tracks['/turtle2/pose']}))
    assert statuses(results) == {'mimic_copies': 'failed'}
    assert results['mimic_copies'].seen.endswith('/turtlesim2/turtle1 drives 0.00 m')


def test_a_node_of_the_name_is_no_world() -> None:
    decoy = node('/turtlesim2/sim', program(3, 'mine', 'decoy'))
    results = graded('large_project', lambda s: run(s, nodes=[node('/sim', WORLD), decoy, node('/listener', LISTENER)]))
    assert results['second_world_is_there'].status == 'failed'
