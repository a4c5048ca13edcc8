"""The rubric of circle.launch.py: a world, a node, and a radius from a launch argument.

The odometry of the robot decides the points for the movement. Two runs have two radii that the student cannot predict. The
launch file may reach the result in any way.
"""

from __future__ import annotations

from collections.abc import Iterable
from random import Random

from edugrade import Evidence, Failure, Missing, Rubric, Scenario, check
from edugrade.library.arguments import require_declared, require_default
from edugrade.library.circle_fit import fit_circle
from edugrade.library.deaths import refuse_dead
from edugrade.library.following import require_driver
from edugrade.library.launched import find_processes, included_files, require_process
from edugrade.library.movement import length, odometry_track, since
from edugrade.library.parameters import require_parameter
from edugrade.library.written import parameter_of_node

ARGUMENT, DEFAULT = 'circle_radius', '1.0'
PACKAGE, EXECUTABLE = 'part3_beyond_basics', 'param_circle.py'
TOLERANCE = 0.02  # largest error, as a share of the radius
SETTLED_S = 2.0  # time when the robot exists and drives
SHORTEST_TRACK_M = 0.5
ADVICE = f'set the radius from the launch argument {ARGUMENT}: a fixed number is right for only one circle'


def scenarios(random: Random) -> list[Scenario]:
    """Return a run with a radius that the student cannot predict, and a run with the default."""
    chosen = random.choice([*range(35, 86), *range(115, 126)]) / 100
    return [Scenario('chosen', {ARGUMENT: f'{chosen:.2f}'}), Scenario('usual', defaults={ARGUMENT: DEFAULT})]


@check(points=1)
def argument_is_declared(run: Evidence) -> None:
    """The launch argument circle_radius is declared"""
    require_declared(run, ARGUMENT, DEFAULT)


@check(points=2)
def world_is_there(run: Evidence) -> None:
    """The launch file starts the robot and its world"""
    for recording in run.values():
        if not odometry_track(recording):
            included = ', '.join(included_files(recording)) or 'no included launch files'
            raise Missing(
                'the robot, which publishes its position on /odom,',
                seen=included,
                expected='an included empty_world.launch.py of the package turtlebot3_gazebo',
                where=run.source.place,
                try_='add IncludeLaunchDescription(...) with the path PathJoinSubstitution('
                "[FindPackageShare('turtlebot3_gazebo'), 'launch', 'empty_world.launch.py'])",
            )


@check(points=1)
def node_is_started(run: Evidence) -> None:
    """The launch file starts param_circle.py of part3_beyond_basics"""
    require_process(run, PACKAGE, EXECUTABLE)


@check(points=1, needs=[node_is_started])
def no_node_dies(run: Evidence) -> None:
    """No node dies before the end"""
    refuse_dead(run)


@check(points=2, needs=[no_node_dies])
def radius_is_passed(run: Evidence) -> None:
    """The node's parameter radius has the value of circle_radius"""
    radii, code = {name: _asked_radius(run, name) for name in run}, f"LaunchConfiguration('{ARGUMENT}')"
    require_parameter(run, PACKAGE, EXECUTABLE, 'radius', radii, parameter_of_node(run, 'radius', code), code=code)


@check(points=1, needs=[argument_is_declared, node_is_started], explained_by=[no_node_dies, radius_is_passed])
def default_is_one_metre(run: Evidence) -> None:
    """Without an argument, the radius is 1.0"""
    require_default(run, ARGUMENT, DEFAULT, _has_the_default)


def _has_the_default(run: Evidence) -> None:
    """Require that the node reads the default without an argument."""
    require_parameter(run, PACKAGE, EXECUTABLE, 'radius', dict.fromkeys(run, float(DEFAULT)), ADVICE)


@check(points=4, needs=[world_is_there, no_node_dies], explained_by=[radius_is_passed])
def circle_is_driven(run: Evidence) -> None:
    """The robot drives circles of the requested radius, measured on /odom"""
    wanted = [_asked_radius(run, name) for name in run]
    measured = [_measured_radius(run, name) for name in run]
    require_driver(run, '', PACKAGE, EXECUTABLE)
    if not all(abs(seen - asked) <= TOLERANCE * asked for seen, asked in zip(measured, wanted, strict=True)):
        raise Failure(
            f'the circles should have a radius of {_metres(run, wanted, " and of ")}',
            expected=_metres(run, wanted, '\n'),
            seen=_metres(run, measured, '\n'),
            where=find_processes(run.first, PACKAGE, EXECUTABLE)[0].origin,
            try_=ADVICE,
        )


def _asked_radius(run: Evidence, scenario: str) -> float:
    return float(run.arguments_of(scenario)[ARGUMENT])


def _measured_radius(run: Evidence, scenario: str) -> float:
    track = since(odometry_track(run[scenario]), SETTLED_S)
    expected = f'a circle in the run with {run.scenario(scenario).words}'
    if not length(track) >= SHORTEST_TRACK_M:
        raise Failure(
            'the robot does not move',
            expected=expected,
            where=run.source.place,
            seen=f'a distance of {length(track):.2f} m in {run[scenario].duration_s:g} s',
            try_=f'compare the topic that {EXECUTABLE} publishes with the topic of the robot, /cmd_vel',
        )
    circle = fit_circle([(x, y) for _, x, y in track])
    if not (circle is not None and circle.residual <= TOLERANCE * circle.radius):
        seen = 'a straight line' if circle is None else f'a track that is {circle.residual:.2f} m off the best circle'
        raise Failure(
            'the robot does not drive a circle',
            expected=expected,
            seen=seen,
            where=run.source.place,
            try_='find out whether a second node publishes velocities',
        )
    return circle.radius


def _metres(run: Evidence, values: Iterable[float], joint: str) -> str:
    return joint.join(f'{value:.2f} m with {run.scenario(name).words}' for name, value in zip(run, values, strict=True))


RUBRIC = Rubric(
    title='A circle of any radius',
    scenarios=scenarios,
    checks=[
        argument_is_declared,
        world_is_there,
        node_is_started,
        no_node_dies,
        radius_is_passed,
        default_is_one_metre,
        circle_is_driven,
    ],
)
