"""The rubric of circle.launch.py: a world, a node, and a radius that comes from outside.

The mark for the movement is given for what the robot's odometry shows in two runs, with two radii that nobody
can know beforehand; how the launch file gets there is its own business.
"""

from __future__ import annotations

from random import Random

from edugrade import Evidence, Failure, Mismatch, Missing, Rubric, Scenario, check
from edugrade.library.circle_fit import fit_circle
from edugrade.library.launched import find_processes, node_names, refuse_ended, require_process
from edugrade.library.movement import length, odometry_track

ARGUMENT = 'circle_radius'
PACKAGE, EXECUTABLE = 'part3_beyond_basics', 'param_circle.py'
TOLERANCE = 0.02  # of the radius
SETTLED_S = 2.0  # the robot has been spawned and drives
SHORTEST_TRACK_M = 0.5


def scenarios(random: Random) -> list[Scenario]:
    """A small circle and a large one."""
    small, large = random.randint(35, 60) / 100, random.randint(85, 120) / 100
    return [
        Scenario(name, {ARGUMENT: f'{radius:.2f}'}, duration_s=20.0)
        for name, radius in (('small', small), ('large', large))
    ]


@check(points=2)
def world_is_there(run: Evidence) -> None:
    """The launch file brings the world with the robot"""
    for recording in run.values():
        if not odometry_track(recording):
            included = (
                ', '.join(path.rsplit('/', 1)[-1] for path in recording.includes)
                or 'no launch file is included'
            )
            raise Missing(
                'the robot: nothing publishes its position on /odom, so the world',
                where=run.source.place,
                expected='an IncludeLaunchDescription of empty_world.launch.py of turtlebot3_gazebo',
                seen=included,
                try_='add IncludeLaunchDescription(...) with the path PathJoinSubstitution('
                "[FindPackageShare('turtlebot3_gazebo'), 'launch', 'empty_world.launch.py'])",
            )


@check(points=1)
def node_is_started(run: Evidence) -> None:
    """The launch file starts param_circle.py of part3_beyond_basics"""
    require_process(run, PACKAGE, EXECUTABLE, try_='add this Node to the list of the LaunchDescription')


@check(points=2)
def argument_is_declared(run: Evidence) -> None:
    """The launch argument circle_radius is declared, with a default"""
    declared = {argument.name: argument for argument in run.first.launch.declared}
    if ARGUMENT not in declared:
        raise Missing(
            f'the launch argument "{ARGUMENT}"',
            name=ARGUMENT,
            among=declared,
            where=run.source.place,
            try_=f"add DeclareLaunchArgument('{ARGUMENT}', default_value='1.0', description='...')",
        )
    argument = declared[ARGUMENT]
    if argument.default is None:
        place = None if argument.file is None else (argument.file, argument.line)
        raise Missing(
            f'a default value of "{ARGUMENT}"',
            expected="default_value='1.0'",
            where=place,
            seen='no default_value',
            try_='give it a default_value, so that the file can be launched without arguments too',
        )


@check(points=1, needs=[node_is_started])
def node_stays_alive(run: Evidence) -> None:
    """param_circle.py runs until the end"""
    refuse_ended(run, PACKAGE, EXECUTABLE)


@check(points=2, needs=[node_stays_alive, argument_is_declared])
def radius_is_passed(run: Evidence) -> None:
    """The node's parameter radius has the value of circle_radius"""
    wanted = [float(run.scenario(name).arguments[ARGUMENT]) for name in run]
    seen = [_radius_parameter(run, name) for name in run]
    if seen == wanted:
        return
    same = len(set(seen)) == 1
    raise Mismatch(
        'the parameter radius',
        ' and '.join(f'{ARGUMENT}:={value:.2f}' for value in wanted),
        ' and '.join(str(value) for value in seen) + (', whatever the argument is' if same else ''),
        where=find_processes(run.first, PACKAGE, EXECUTABLE)[0].origin,
        try_=f"give the Node parameters=[{{'radius': LaunchConfiguration('{ARGUMENT}')}}]",
    )


@check(points=4, needs=[world_is_there, node_stays_alive])
def circle_is_driven(run: Evidence) -> None:
    """The robot drives circles of the radii asked for (measured from /odom)"""
    measured = {name: _measured_radius(run, name) for name in run}
    wanted = {name: float(run.scenario(name).arguments[ARGUMENT]) for name in run}
    if any(abs(measured[name] - wanted[name]) > TOLERANCE * wanted[name] for name in run):
        raise Mismatch(
            'the radius that the robot drives',
            _metres(wanted.values()),
            _metres(measured.values()),
            where=find_processes(run.first, PACKAGE, EXECUTABLE)[0].origin,
            try_=f'let the launch argument {ARGUMENT} decide the radius; a fixed number fits one circle only',
        )


def _radius_parameter(run: Evidence, scenario: str) -> object:
    recording = run[scenario]
    for node in node_names(recording, find_processes(recording, PACKAGE, EXECUTABLE)):
        parameter = recording.parameters(node).get('radius')
        if parameter is not None:
            return parameter.value
    return None


def _measured_radius(run: Evidence, scenario: str) -> float:
    track = [sample for sample in odometry_track(run[scenario]) if sample[0] >= SETTLED_S]
    circle = fit_circle([(x, y) for _, x, y in track])
    if length(track) < SHORTEST_TRACK_M:
        raise Failure(
            'the robot does not move',
            expected=f'a circle, launched with {run.scenario(scenario).command}',
            seen=f'{length(track):.2f} m travelled in {run[scenario].duration_s:g} s',
            where=run.source.place,
            try_='compare the topic that param_circle.py publishes with what the robot listens to: /cmd_vel',
        )
    if circle is None or circle.residual > TOLERANCE * circle.radius:
        raise Failure(
            'the robot moves, but not on a circle',
            expected=f'a circle, launched with {run.scenario(scenario).command}',
            seen='a straight line'
            if circle is None
            else f'{circle.residual:.2f} m away from the best circle on average',
            where=run.source.place,
            try_='look whether a second node sends velocities too',
        )
    return circle.radius


def _metres(values: object) -> str:
    return ' and '.join(f'{value:.2f} m' for value in list(values))  # type: ignore[call-overload]


RUBRIC = Rubric(
    title='A circle of any radius',
    scenarios=scenarios,
    checks=[
        world_is_there,
        node_is_started,
        argument_is_declared,
        node_stays_alive,
        radius_is_passed,
        circle_is_driven,
    ],
)
