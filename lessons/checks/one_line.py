"""Lesson 9: four lines of a broadcaster become one, and nothing moves."""

from __future__ import annotations

from math import cos, hypot
from os.path import basename

from edugrade import Evidence, Failure, Rubric, Scenario, check
from edugrade.library.frames import require_frame, tilt, yaw
from edugrade.library.movement import turtle_track

PROGRAM = 'turtle_tf2_broadcaster.py'


@check(points=1)
def the_frame_is_where_it_was(run: Evidence) -> None:
    """tf knows turtle1 where the simulator has it"""
    require_frame(run, 'turtle1', 'world', f'look at the broadcaster in {PROGRAM}')
    x, y = turtle_track(run.first, '/turtle1/pose')[-1][1:]
    frame = run.first.frames_at(run.first.duration_s)['turtle1']
    seen, turn = frame.translation, run.first.messages('/turtle1/pose')[-1][1].theta
    if not (tilt(frame) < 0.1 and abs(seen[2]) < 0.1 and cos(yaw(frame) - turn) > 0.99):
        raise Failure(
            'the frame turtle1 is turned in another way, or is not on the ground',
            expected=f'z=0.00, yaw={turn:.2f}, no roll and no pitch',
            seen=f'z={seen[2]:.2f}, yaw={yaw(frame):.2f}, tilted by {tilt(frame):.2f}',
            where=run.source.place_in(PROGRAM, 'def '),
            try_='which number of turned(roll, pitch, yaw) is theta of the pose?',
        )
    if not hypot(seen[0] - x, seen[1] - y) < 0.1:
        raise Failure(
            'the frame turtle1 is elsewhere',
            expected=f'x={x:.2f}, y={y:.2f}',
            seen=f'x={seen[0]:.2f}, y={seen[1]:.2f}',
            where=run.source.place_in(PROGRAM, 'def '),
            try_='which numbers of the pose are x and y?',
        )


@check(points=1, needs=[the_frame_is_where_it_was])
def it_is_one_line(run: Evidence) -> None:
    """The four lines are one"""
    text = next((text for path, text in run.source.texts().items() if basename(path) == PROGRAM), '')
    if 't.transform' in text:
        raise Failure(
            'lines with t.transform are still there',
            where=run.source.place_in(PROGRAM, r't\.transform'),
            try_='placed(...) of lesson 8 fills in all of them',
        )


RUBRIC = Rubric(
    title='One line for four',
    decoys=1.0,  # the student's own program may publish the same frame in any way
    of='my_ws/src/learning_tf2_py/launch/turtle_tf2_demo.launch.py',
    scenarios=lambda random: [Scenario('run', {}, 6.8)],
    checks=[the_frame_is_where_it_was, it_is_one_line],
)
