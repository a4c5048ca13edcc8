"""What the circle's rubric says of small made-up runs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from edugrade import Scenario
from edugrade.grading import grade, plan_work
from edugrade.submission import Submission
from fake_recording import FakeRecording, arc, circle_run, graded, process

from edulaunch.engine.recording.records import DeclaredArgument, LaunchRecord, NodeRecord


def radius(scenario: Scenario) -> float:
    return float({**scenario.defaults, **scenario.arguments}['circle_radius'] or 0)


def statuses(results: Any) -> dict[str, str]:
    return {name: result.status for name, result in results.items() if result.status != 'passed'}


def test_a_correct_launch_passes_everything() -> None:
    results = graded('circle', lambda scenario: circle_run(radius(scenario)))
    assert statuses(results) == {}
    assert sum(result.earned for result in results.values()) == 12


def test_another_radius_and_the_default_are_asked_for_and_an_edit_changes_the_other_one() -> None:
    asked: list[float] = []
    for seed in (1, 2):
        graded('circle', lambda scenario: asked.append(radius(scenario)) or circle_run(1.0), seed)  # type: ignore[func-returns-value]
    assert asked[1] == asked[3] == 1.0 and all(abs(each - 1.0) > 0.1 for each in (asked[0], asked[2]))
    assert asked[0] != asked[2]


def test_a_fixed_radius_fails_in_the_parameter_which_explains_the_rest() -> None:
    results = graded('circle', lambda scenario: circle_run(0.5))
    explained = dict.fromkeys(('default_is_one_metre', 'circle_is_driven'), 'not_run')
    assert statuses(results) == {'radius_is_passed': 'failed', **explained}
    assert results['radius_is_passed'].where == ('/student/a.launch.py', 7)
    assert {results[name].root_cause for name in explained} == {'radius_is_passed'}


@pytest.mark.processes
def test_a_second_node_with_the_right_radius_does_not_hide_the_one_that_drives(tmp_path: Path) -> None:
    text = (Path(__file__).resolve().parents[3] / 'solutions' / 'circle.launch.py').read_text()
    shown = (
        "Node(package='part3_beyond_basics', executable='param_circle.py', name='shown', remappings=[('/cmd_vel', '/none')],\n"
    )
    given = "             parameters=[{'radius': LaunchConfiguration('circle_radius')}]),\n"
    own = "            parameters=[{'radius': LaunchConfiguration('circle_radius')}],\n"
    (tmp_path / 'circle.launch.py').write_text(
        text.replace(own, '').replace('        Node(\n', f'        {shown}{given}        Node(\n')
    )
    (report,) = grade([plan_work(Submission(str(tmp_path / 'circle.launch.py')))])
    assert [each.name for each in report.results if each.status == 'failed'] == ['radius_is_passed']
    assert report.earned == 5.0  # what the failed check explains gives no points either


def test_a_misspelt_parameter_is_recognised() -> None:
    node = process('part3_beyond_basics', 'param_circle.py', parameter_origins={'raduis': 'launch argument'})
    results = graded('circle', lambda scenario: circle_run(0.5, processes=[node]), wrote="{'raduis': 0.5}")
    assert results['radius_is_passed'].reason == 'the parameter radius of the Node is missing'
    assert results['radius_is_passed'].try_ == 'write "radius" instead of "raduis"'


def test_a_parameter_that_the_robot_does_not_drive_earns_nothing_for_the_movement() -> None:
    results = graded('circle', lambda scenario: circle_run(radius(scenario), tracks={'/odom': arc(0.5)}))
    assert statuses(results) == {'circle_is_driven': 'failed'}


def test_without_a_world_the_movement_is_not_judged() -> None:
    results = graded('circle', lambda scenario: circle_run(radius(scenario), tracks={}))
    assert statuses(results) == {'world_is_there': 'failed', 'circle_is_driven': 'not_run'}
    assert results['world_is_there'].where == ('/student/a.launch.py', 2)


def test_a_robot_that_stands_is_told_from_one_on_a_line() -> None:
    standing = [(t / 10, 0.0, 0.0) for t in range(200)]
    line = [(t / 10, t / 100, 0.0) for t in range(200)]
    reasons = [
        graded('circle', lambda scenario, track=track: circle_run(radius(scenario), tracks={'/odom': track}))[  # type: ignore[misc]
            'circle_is_driven'
        ].reason
        for track in (standing, line)
    ]
    assert reasons == ['the robot does not move', 'the robot does not drive a circle']


def test_a_misspelt_argument_is_recognised() -> None:
    argument = DeclaredArgument('circle_radious', '1.0', '', None, '/student/a.launch.py', 3)
    run = LaunchRecord(declared=[argument])
    results = graded('circle', lambda scenario: circle_run(radius(scenario), launch=run), wrote="'circle_radious'")
    assert 'write "circle_radius" instead of "circle_radious"' in results['argument_is_declared'].try_


def test_a_missing_default_costs_its_own_point_only() -> None:
    argument = DeclaredArgument('circle_radius', None, '', None, '/student/a.launch.py', 3)
    results = graded('circle', lambda scenario: circle_run(radius(scenario), launch=LaunchRecord(declared=[argument])))
    assert results['default_is_one_metre'].where == ('/student/a.launch.py', 3)
    assert sum(result.earned for result in results.values()) == 11


def defaulted(described: str) -> Any:
    argument = DeclaredArgument('circle_radius', described, '', None, '/student/a.launch.py', 3)
    return graded('circle', lambda scenario: circle_run(radius(scenario), launch=LaunchRecord(declared=[argument])))


def test_the_default_is_the_one_that_the_task_names_and_costs_one_point() -> None:
    results = defaulted("'2.0'")
    assert results['default_is_one_metre'].try_ == "write default_value='1.0'"
    assert statuses(results) == {'default_is_one_metre': 'failed'}
    assert results['default_is_one_metre'].points == 1


@pytest.mark.parametrize('described', ["'1.0'", "'1.00'", "'1'", "'1' + '.0'", "'1e0'", "LaunchConfig('other')"])
def test_a_default_counts_as_the_number_it_is(described: str) -> None:
    assert statuses(defaulted(described)) == {}


@pytest.mark.parametrize('described', ["'nan'", "'inf'", "'10'", "''"])
def test_another_default_does_not(described: str) -> None:
    assert statuses(defaulted(described)) == {'default_is_one_metre': 'failed'}


NAN, HUGE = float('nan'), 1e200


@pytest.mark.parametrize('where', [NAN, HUGE, float('inf')])
def test_a_position_that_is_not_a_number_earns_nothing(where: float) -> None:
    track = [(t / 10, where * ((t % 3) - 1), where) for t in range(200)]
    results = graded('circle', lambda scenario: circle_run(radius(scenario), tracks={'/odom': track}))
    assert results['circle_is_driven'].earned == 0
    assert 'grader_broke' not in statuses(results).values()


def test_a_single_nan_in_a_good_track_is_named() -> None:
    def spoilt(scenario: Scenario) -> FakeRecording:
        return circle_run(radius(scenario), tracks={'/odom': [*arc(radius(scenario)), (20.0, NAN, 0.0)]})

    result = graded('circle', spoilt)['world_is_there']
    assert (result.reason, result.seen) == ('a position on /odom is not a number', 'nan or inf at 20.00 s')


def test_another_node_is_named() -> None:
    results = graded(
        'circle',
        lambda scenario: circle_run(radius(scenario), processes=[process('a', 'param_cirle.py')]),
        wrote='param_cirle.py',
    )
    assert results['node_is_started'].try_ == 'write "param_circle.py" instead of "param_cirle.py"'


def test_a_node_that_died_shows_its_exception() -> None:
    error = {'type': 'ValueError', 'message': 'bad radius', 'file': '/ws/param_circle.py', 'line': 9}
    dead = process('part3_beyond_basics', 'param_circle.py', ended_s=0.5, returncode=1, exception=error)
    results = graded('circle', lambda scenario: circle_run(radius(scenario), processes=[dead]))
    assert results['no_node_dies'].seen == 'ValueError: bad radius'
    assert results['no_node_dies'].where == ('/ws/param_circle.py', 9)
    assert statuses(results) == {'no_node_dies': 'failed', 'radius_is_passed': 'not_run', 'circle_is_driven': 'not_run'}


def test_a_node_of_the_name_from_elsewhere_is_not_the_node() -> None:
    for argv in (['/ws/lib/part3_beyond_basics/param_circle.py'], ['python3', 'fake.py', '/x/param_circle.py']):
        copy = process('part3_beyond_basics', 'param_circle.py')._replace(argv=argv)
        result = graded('circle', lambda s, copy=copy: circle_run(radius(s), processes=[copy]))['node_is_started']  # type: ignore[misc]
        assert result.seen == ' '.join(argv)
        assert 'is not the program of edulaunch' in result.reason


def test_odometry_of_ones_own_is_no_robot() -> None:
    def claimed(scenario: Scenario) -> FakeRecording:
        run = circle_run(radius(scenario))
        own = process('mine', 'fake', line=9)._replace(name='fake-2')
        run.processes.append(own)
        run.nodes.append(NodeRecord('/fake', own.name, 0.0, None, [('/odom', 'nav_msgs/msg/Odometry')], [], [], []))
        return run

    results = graded('circle', claimed)
    assert statuses(results) == {'world_is_there': 'failed', 'circle_is_driven': 'not_run'}
    assert results['world_is_there'].reason == (
        '/fake publishes on /odom, but only a program of turtlebot3_gazebo may publish there'
    )
    assert results['world_is_there'].where == ('/student/a.launch.py', 9)


def test_a_fake_is_a_recording_for_every_question_of_the_rubric() -> None:
    from edulaunch.engine.recording import Recording

    names = [name for name in vars(FakeRecording()) if name not in ('tracks', 'radius', 'frames', 'duration_s', 'start_ns')]
    assert [
        name
        for name in [*names, 'series', 'wires', 'parameters', 'frames_at', 'includes', 'topics']
        if not hasattr(Recording, name)
    ] == []
