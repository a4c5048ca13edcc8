"""The rubric of follow.launch.py: turtle2 follows turtle1 through tf.

Two runs: turtle1 stands, and turtle1 drives a square. Following is measured from the poses that turtlesim
publishes: a turtle that only stands at a good place, or drives a path known beforehand, is near turtle1 in
one of the runs at most.
"""

from __future__ import annotations

from random import Random

from edugrade import Evidence, Failure, Missing, Rubric, Scenario, check
from edugrade.library.launched import require_process
from edugrade.library.movement import distances, farthest, length, turtle_track

LEADER, FOLLOWER = '/turtle1/pose', '/turtle2/pose'
SETTLED_S = 15.0  # the follower spawns at about 2 s and has caught up long before
BOUNDS_M = {
    'standing': 0.25,
    'moving': 2.5,
}  # the square is driven at 1 m/s, and a follower of 0.5 d per second lags 1 to 1.7 m


def scenarios(random: Random) -> list[Scenario]:
    """turtle1 stands, turtle1 moves; how long is not known beforehand."""
    duration_s = random.randint(40, 48) / 2
    return [Scenario('standing', {}, duration_s), Scenario('moving', {'move': 'true'}, duration_s)]


@check(points=1)
def turtlesim_is_started(run: Evidence) -> None:
    """The launch file starts turtlesim_node of turtlesim"""
    require_process(
        run, 'turtlesim', 'turtlesim_node', try_='add this Node to the list of the LaunchDescription'
    )
    for name in run:
        if not turtle_track(run[name], LEADER):
            raise Missing(
                f'the topic {LEADER}',
                where=run.source.place,
                name=LEADER,
                among=run[name].topics,
                try_='start turtlesim_node without a namespace',
            )


@check(points=2, needs=[turtlesim_is_started])
def leader_is_on_tf(run: Evidence) -> None:
    """tf knows where turtle1 is: the frame turtle1 in the frame world"""
    _require_frame(run, 'turtle1')


@check(points=2, needs=[turtlesim_is_started])
def follower_exists(run: Evidence) -> None:
    """turtle2 is spawned"""
    for name in run:
        if not turtle_track(run[name], FOLLOWER):
            turtles = [topic.split('/')[-2] for topic in run[name].topics if topic.endswith('/pose')]
            raise Missing(
                'turtle2',
                name='turtle2',
                seen='only ' + ', '.join(turtles),
                where=run.source.place,
                try_='turtle_tf2_listener spawns it: '
                "add Node(package='turtle_tf2_py', executable='turtle_tf2_listener', ...)",
            )


@check(points=2, needs=[follower_exists])
def follower_is_on_tf(run: Evidence) -> None:
    """tf knows where turtle2 is: the frame turtle2 in the frame world"""
    _require_frame(run, 'turtle2')


@check(points=1, needs=[turtlesim_is_started])
def leader_moves_when_asked(run: Evidence) -> None:
    """turtle1 stands still, and drives when launched with move:=true"""
    driven = {name: length(turtle_track(run[name], LEADER)) for name in run}
    if driven['standing'] > 0.1 or driven['moving'] < 2.0:
        raise Failure(
            'turtle1 does not do as the launch argument move says',
            where=run.source.place,
            expected='no movement without arguments, a square with move:=true',
            seen=f'{driven["standing"]:.1f} m without arguments, {driven["moving"]:.1f} m with move:=true',
            try_="leave draw_square with condition=IfCondition(LaunchConfiguration('move')), as it was",
        )


@check(points=2, needs=[leader_is_on_tf, follower_is_on_tf])
def standing_leader_is_reached(run: Evidence) -> None:
    """turtle2 comes to turtle1 while turtle1 stands, and stays there"""
    _require_near(run, 'standing')


@check(points=2, needs=[leader_is_on_tf, follower_is_on_tf, leader_moves_when_asked])
def moving_leader_is_followed(run: Evidence) -> None:
    """turtle2 stays close behind turtle1 while turtle1 moves"""
    _require_near(run, 'moving')


def _require_frame(run: Evidence, turtle: str) -> None:
    for name, recording in run.items():
        frames = recording.frames_at(recording.duration_s)
        frame = frames.get(turtle)
        if frame is None:
            broadcasting = ', '.join(f'{child} in {known.parent}' for child, known in frames.items())
            raise Missing(
                f'the frame {turtle}',
                name=turtle,
                seen=broadcasting or 'no frames at all',
                where=run.source.place,
                expected=f'the frame {turtle} in the frame world',
                try_=f"add a turtle_tf2_broadcaster with parameters=[{{'turtlename': '{turtle}'}}]",
            )
        if frame.parent != 'world':
            raise Failure(
                f'the frame {turtle} hangs in another frame when launched with {run.scenario(name).words}',
                expected='world',
                seen=frame.parent,
                where=run.source.place,
                try_='broadcast it with header.frame_id world',
            )


def _require_near(run: Evidence, name: str) -> None:
    bound = BOUNDS_M[name]
    worst = farthest(distances(turtle_track(run[name], LEADER), turtle_track(run[name], FOLLOWER)), SETTLED_S)
    if worst is not None and worst[1] <= bound:
        return
    seen = (
        f'no pose of turtle2 after {SETTLED_S:g} s'
        if worst is None
        else f'{worst[1]:.2f} m at {worst[0]:.2f} s'
    )
    raise Failure(
        f'turtle2 is too far from turtle1 when launched with {run.scenario(name).words}',
        expected=f'at most {bound:g} m from {SETTLED_S:g} s on',
        seen=seen,
        where=run.source.place,
        try_="start turtle_tf2_listener with parameters=[{'target_frame': 'turtle1'}] and both broadcasters",
    )


RUBRIC = Rubric(
    title='turtle2 follows turtle1',
    scenarios=scenarios,
    checks=[
        turtlesim_is_started,
        leader_is_on_tf,
        follower_exists,
        follower_is_on_tf,
        leader_moves_when_asked,
        standing_leader_is_reached,
        moving_leader_is_followed,
    ],
)
