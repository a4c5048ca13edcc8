"""The rubric of large_project: a package that uses its launch files more than once.

Its two runs have two goals: the carrot, and turtle1 itself.
"""

from __future__ import annotations

from random import Random

from edugrade import Evidence, Failure, Rubric, Scenario, check
from edugrade.library.deaths import refuse_dead, refuse_gone
from edugrade.library.following import require_arrival, require_copy, require_driver, require_near, still
from edugrade.library.frames import frames_at_end, place_in, require_frame
from edugrade.library.launched import require_process
from edugrade.library.node_graph import loose_ends, require_node
from edugrade.library.parameters import named_origin, node_parameter, refuse_missing_file, require_parameter, value_and_origin

from edulaunch.engine.recording.records import Parameter

LISTENER = ('turtle_tf2_py', 'turtle_tf2_listener')
WATER = {'background_r': 150, 'background_g': 86, 'background_b': 255}
GOALS = ('carrot1', 'turtle1')
ABSENT = Parameter(None, 'not declared')
SETTLED_S = 15.0
BOUND_M = 0.3
TOP, CONFIG = 'launch/large_project.launch.py', 'config/turtlesim.yaml'


def scenarios(random: Random) -> list[Scenario]:
    """Return a run for each goal. The student does not know their exact duration."""
    duration_s = random.randint(36, 44) / 2
    return [Scenario(goal, {'goal': goal}, duration_s) for goal in GOALS]


@check(points=1)
def no_node_dies(run: Evidence) -> None:
    """No node dies before the end"""
    refuse_dead(run)
    refuse_gone(run)


@check(points=1, needs=[no_node_dies])
def first_world_is_there(run: Evidence) -> None:
    """The first world has the node /sim"""
    require_node(run, '/sim', 'turtlesim', 'include world.launch.py', 'turtlesim_node')


@check(points=2, needs=[no_node_dies])
def second_world_is_there(run: Evidence) -> None:
    """The second world has the node /turtlesim2/sim, in its own namespace"""
    advice = "add GroupAction([PushRosNamespace('turtlesim2'), include('world.launch.py')])"
    require_node(run, '/turtlesim2/sim', 'turtlesim', advice, 'turtlesim_node')


@check(points=3, needs=[first_world_is_there, second_world_is_there])
def water_comes_from_the_file(run: Evidence) -> None:
    """Both worlds have the colours of config/turtlesim.yaml"""
    for node in ('/sim', '/turtlesim2/sim'):
        seen = {name: node_parameter(run.first, node, 'turtlesim', name, value) or ABSENT for name, value in WATER.items()}
        seen = {name: found._replace(origin=named_origin(run, found, node, name)) for name, found in seen.items()}
        wrong = {
            name: parameter
            for name, parameter in seen.items()
            if parameter.value != WATER[name] or not parameter.origin.startswith('turtlesim.yaml')
        }
        if wrong:
            refuse_missing_file(run, wrong.values(), 'turtlesim')
            is_key = all(parameter.origin == 'default' for parameter in seen.values())
            key = 'begin the file with /**: above ros__parameters, because /** matches every node'
            raise Failure(
                f'{", ".join(wrong)} of {node} should come from {CONFIG}',
                expected='\n'.join(f'{name} is {WATER[name]}' for name in wrong),
                seen='\n'.join(f'{name} is {value_and_origin(parameter)}' for name, parameter in wrong.items()),
                where=run.source.place_in(CONFIG, r'\bros__parameters\b|^\S+:'),
                try_=key if is_key else f'check the name and the value of {", ".join(wrong)} in {CONFIG}',
            )


@check(points=2, needs=[no_node_dies])
def goal_is_passed_on(run: Evidence) -> None:
    """The listener's parameter target_frame is the launch argument goal"""
    require_process(run, *LISTENER)
    require_parameter(
        run,
        *LISTENER,
        'target_frame',
        {name: run.scenario(name).arguments['goal'] for name in run},
        "pass target_frame=LaunchConfiguration('goal') to the included follower.launch.py",
        run.source.place_in(TOP, r"^(?!    ros2 ).*\('follower.launch.py'"),
        "LaunchConfiguration('goal')",
    )


@check(points=2, needs=[first_world_is_there, goal_is_passed_on])
def goal_is_reached(run: Evidence) -> None:
    """turtle2 drives to the goal and stays there"""
    for goal in GOALS:
        require_frame(
            run, goal, 'turtle1' if goal == 'carrot1' else 'world', 'restore the includes and nodes that the starter file has'
        )
        place = place_in(frames_at_end(run, goal), goal, 'world')
        require_near(
            run,
            goal,
            [] if place is None else still(place),
            '/turtle2',
            BOUND_M,
            SETTLED_S,
            'find out whether another node than the listener drives turtle2',
        )
        require_arrival(run, goal, '/turtle2', 'set target_frame of the listener to the goal')
    require_driver(run, '/turtle2', *LISTENER)


@check(points=1, needs=[second_world_is_there], explained_by=[goal_is_passed_on])
def mimic_copies(run: Evidence) -> None:
    """turtle1 of the second world copies turtle2"""
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
