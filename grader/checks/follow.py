"""The rubric of follow.launch.py: turtle2 follows turtle1 through tf.

In its first run, turtle1 does not move. In its second run, turtle1 drives a square. The checks measure the poses that
turtlesim publishes. A turtle that only waits at a good position, or drives a fixed path, is near turtle1 in at most one run.
"""

from __future__ import annotations

from random import Random

from edugrade import Evidence, Failure, Missing, Rubric, Scenario, check
from edugrade.library.deaths import refuse_dead, refuse_gone
from edugrade.library.following import driven_track, require_arrival, require_driver, require_near, require_pursuit
from edugrade.library.frames import require_broadcast
from edugrade.library.identity import nodes_of
from edugrade.library.launched import find_processes, refuse_shared_names, require_process
from edugrade.library.movement import length, turtle_track
from edugrade.library.parameters import find_parameter, parameter_advice

LEADER, FOLLOWER = '/turtle1/pose', '/turtle2/pose'
SETTLED_S = 15.0  # the follower appears at about 2 s, and has caught up long before this time
# turtle1 drives along the square at 1 m/s. A follower that covers half of the distance in a second is 1 to 1.7 m behind it.
BOUNDS_M = {'standing': 0.25, 'moving': 2.5}
LISTENER = ('turtle_tf2_py', 'turtle_tf2_listener')
LISTEN = "start turtle_tf2_listener with parameters=[{'target_frame': 'turtle1'}]"


def scenarios(random: Random) -> list[Scenario]:
    """Return a run without and a run with movement of turtle1. The student does not know their exact duration."""
    duration_s = random.randint(40, 48) / 2
    return [Scenario('standing', {}, duration_s), Scenario('moving', {'move': 'true'}, duration_s)]


@check(points=1)
def turtlesim_is_started(run: Evidence) -> None:
    """The launch file starts turtlesim_node of turtlesim"""
    require_process(run, 'turtlesim', 'turtlesim_node')


@check(points=1, needs=[turtlesim_is_started])
def no_node_dies(run: Evidence) -> None:
    """No node dies before the end"""
    refuse_dead(run)
    refuse_gone(run)


@check(needs=[no_node_dies])
def leader_exists(run: Evidence) -> None:
    """The turtle turtle1 exists"""
    for recording in run.values():
        if not turtle_track(recording, LEADER):
            poses = [topic for topic in recording.topics if topic.endswith('/pose') and turtle_track(recording, topic)]
            raise Missing(
                f'the turtle with the topic {LEADER}',
                where=find_processes(recording, 'turtlesim', 'turtlesim_node')[0].origin,
                expected=LEADER,
                seen=', '.join(poses) or 'no pose of a turtle',
                try_='start turtlesim_node without a namespace',
            )


@check(points=2, needs=[leader_exists])
def leader_is_on_tf(run: Evidence) -> None:
    """A broadcaster publishes the frame turtle1 with the parent world"""
    _require_frame(run, 'turtle1')


@check(points=1, needs=[leader_exists])
def follower_exists(run: Evidence) -> None:
    """The turtle turtle2 exists"""
    for recording in run.values():
        if not turtle_track(recording, FOLLOWER):
            turtles = [
                topic.split('/')[-2] for topic in recording.topics if topic.endswith('/pose') and turtle_track(recording, topic)
            ]
            own = [recording.nodes[position] for position in nodes_of(recording, *LISTENER)]
            calls = [f'{node.name} calls {name}' for node in own for name, _ in node.clients if name != '/spawn']
            advice = "add Node(package='turtle_tf2_py', executable='turtle_tf2_listener', ...), which spawns turtle2"
            raise Missing(
                'turtle2',
                name='turtle2',
                expected='a turtle named turtle2',
                seen='\n'.join(['only ' + ', '.join(turtles), *(call for call in calls if call.endswith('/spawn'))]),
                where=run.source.own(find_processes(recording, *LISTENER)[0].origin if own else None),
                try_='start turtle_tf2_listener without a namespace, because it calls the service /spawn' if own else advice,
            )


@check(points=2, needs=[follower_exists])
def follower_is_on_tf(run: Evidence) -> None:
    """A broadcaster publishes the frame turtle2 with the parent world"""
    _require_frame(run, 'turtle2')
    refuse_shared_names(run)


@check(points=1, needs=[leader_exists])
def leader_moves_when_asked(run: Evidence) -> None:
    """turtle1 drives only with move:=true"""
    standing, moving = (length(driven_track(run, name, '/turtle1')) for name in ('standing', 'moving'))
    if not (standing <= 0.1 and moving >= 2.0):
        raise Failure(
            'turtle1 ignores the launch argument move',
            where=run.source.place,
            expected='no movement without arguments, a square with move:=true',
            seen=f'{standing:.1f} m without arguments, {moving:.1f} m with move:=true',
            try_="add condition=IfCondition(LaunchConfiguration('move')) to the Node of draw_square",
        )


@check(points=2, needs=[leader_is_on_tf, follower_is_on_tf], explained_by=[leader_moves_when_asked])
def standing_leader_is_reached(run: Evidence) -> None:
    """turtle2 drives to turtle1 and stays there, if turtle1 does not move"""
    _require_near(run, 'standing')
    require_arrival(run, 'standing', '/turtle2', _listener_advice(run))
    require_driver(run, '/turtle2', *LISTENER)


@check(points=2, needs=[leader_is_on_tf, follower_is_on_tf, leader_moves_when_asked], explained_by=[standing_leader_is_reached])
def moving_leader_is_followed(run: Evidence) -> None:
    """turtle2 stays close to turtle1 while turtle1 moves"""
    _require_near(run, 'moving')
    require_pursuit(run, 'moving', '/turtle1', '/turtle2', SETTLED_S, _listener_advice(run))
    require_driver(run, '/turtle2', *LISTENER)


def _require_frame(run: Evidence, turtle: str) -> None:
    require_broadcast(run, turtle, f"add a turtle_tf2_broadcaster with parameters=[{{'turtlename': '{turtle}'}}]")


def _listener_advice(run: Evidence) -> str:
    """Return advice to correct the goal of the listener, or to look for another reason if it has the right goal."""
    goal, own = find_parameter(run.first, *LISTENER, 'target_frame'), find_processes(run.first, *LISTENER)
    if goal is not None and goal.value == 'turtle1':
        return 'find out what else drives turtle2 or moves it'
    return parameter_advice(run, 'target_frame', 'turtle1', goal, own[0].parameter_origins if own else (), LISTEN)


def _require_near(run: Evidence, name: str) -> None:
    require_near(run, name, turtle_track(run[name], LEADER), '/turtle2', BOUNDS_M[name], SETTLED_S, _listener_advice(run))


RUBRIC = Rubric(
    title='turtle2 follows turtle1',
    scenarios=scenarios,
    checks=[
        turtlesim_is_started,
        no_node_dies,
        leader_exists,
        leader_is_on_tf,
        leader_moves_when_asked,
        follower_exists,
        follower_is_on_tf,
        standing_leader_is_reached,
        moving_leader_is_followed,
    ],
)
