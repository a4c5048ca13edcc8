"""The rubric of large_project: a package whose launch files are used more than once.

Two runs with two goals: the carrot, and turtle1 itself.
"""

from __future__ import annotations

from random import Random

from edugrade import Evidence, Mismatch, Rubric, Scenario, check
from edugrade.library.deaths import refuse_dead
from edugrade.library.following import require_arrival, require_copy, require_driver, require_near, still
from edugrade.library.frames import frames_at_end, place_in, require_frame
from edugrade.library.launched import require_process
from edugrade.library.node_graph import loose_ends, require_node
from edugrade.library.parameters import node_parameter, require_parameter

from edulaunch.engine.recording.records import Parameter

LISTENER = ('turtle_tf2_py', 'turtle_tf2_listener')
WATER = {'background_r': 150, 'background_g': 86, 'background_b': 255}
GOALS = ('carrot1', 'turtle1')
ABSENT = Parameter(None, 'not declared')
SETTLED_S = 15.0
BOUND_M = 0.3
TOP, CONFIG = 'launch/large_project.launch.py', 'config/turtlesim.yaml'


def scenarios(random: Random) -> list[Scenario]:
    """A run for each goal; how long is not known beforehand."""
    duration_s = random.randint(36, 44) / 2
    return [Scenario(goal, {'goal': goal}, duration_s) for goal in GOALS]


@check(points=1)
def no_node_dies(run: Evidence) -> None:
    """No node dies before the end"""
    refuse_dead(run)


@check(points=1, needs=[no_node_dies])
def first_world_is_there(run: Evidence) -> None:
    """The first world is there: the node /sim"""
    require_node(run, '/sim', 'turtlesim', 'include world.launch.py')


@check(points=2, needs=[no_node_dies])
def second_world_is_there(run: Evidence) -> None:
    """The second world is in a namespace of its own: the node /turtlesim2/sim"""
    require_node(
        run, '/turtlesim2/sim', 'turtlesim', "add GroupAction([PushRosNamespace('turtlesim2'), include('world.launch.py')])"
    )


@check(points=3, needs=[first_world_is_there, second_world_is_there])
def water_comes_from_the_file(run: Evidence) -> None:
    """Both worlds have the colours of config/turtlesim.yaml"""
    for node in ('/sim', '/turtlesim2/sim'):
        seen = {name: node_parameter(run.first, node, 'turtlesim', name, value) or ABSENT for name, value in WATER.items()}
        wrong = {
            name: parameter
            for name, parameter in seen.items()
            if parameter.value != WATER[name] or not parameter.origin.startswith('turtlesim.yaml')
        }
        if wrong:
            raise Mismatch(
                f'the water of {node}',
                ', '.join(f'{name} {value}' for name, value in WATER.items()),
                ', '.join(f'{name} {parameter.value} (from: {parameter.origin})' for name, parameter in seen.items()),
                where=run.source.place_in(CONFIG, r'\bros__parameters\b|^\S+:'),
                try_='in the file, head the parameters with /**: which stands for every node',
            )


@check(points=2, needs=[no_node_dies])
def goal_is_passed_on(run: Evidence) -> None:
    """The listener's parameter target_frame is the goal that the launch argument names"""
    require_process(run, *LISTENER)
    require_parameter(
        run,
        *LISTENER,
        'target_frame',
        {name: run.scenario(name).arguments['goal'] for name in run},
        "give the include of follower.launch.py target_frame=LaunchConfiguration('goal')",
        run.source.place_in(TOP, r"^(?!    ros2 ).*\('follower.launch.py'"),
    )


@check(points=2, needs=[first_world_is_there, goal_is_passed_on])
def goal_is_reached(run: Evidence) -> None:
    """turtle2 comes to the goal, and stays there"""
    for goal in GOALS:
        require_frame(run, goal, 'turtle1' if goal == 'carrot1' else 'world', 'leave the other includes and nodes in place')
        place = place_in(frames_at_end(run, goal), goal, 'world')
        require_near(
            run,
            goal,
            [] if place is None else still(place),
            '/turtle2',
            BOUND_M,
            SETTLED_S,
            'look whether something else than the listener drives turtle2',
        )
        require_arrival(run, goal, '/turtle2', 'let the listener follow the goal')
    require_driver(run, '/turtle2', *LISTENER)


@check(points=1, needs=[second_world_is_there])
def mimic_copies(run: Evidence) -> None:
    """turtle1 of the second world does what turtle2 does"""
    require_copy(
        run,
        '/turtle2',
        '/turtlesim2/turtle1',
        'compare the remappings in mimic.launch.py with the topics',
        '\n'.join(loose_ends(run.first, 'turtlesim', 'mimic')),
    )
    require_driver(run, '/turtlesim2/turtle1', 'turtlesim', 'mimic')


RUBRIC = Rubric(
    title='A large project',
    scenarios=scenarios,
    checks=[
        no_node_dies,
        first_world_is_there,
        second_world_is_there,
        water_comes_from_the_file,
        goal_is_passed_on,
        goal_is_reached,
        mimic_copies,
    ],
)
