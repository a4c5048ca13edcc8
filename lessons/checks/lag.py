"""The check of lesson 11, your turn: where was turtle1 two seconds ago?"""

from __future__ import annotations

import re

from edugrade import Evidence, Failure, Mismatch, Rubric, Scenario, check

LAUNCH = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='turtlesim', executable='draw_square'),
        Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', parameters=[{'turtlename': 'turtle1'}]),
        ExecuteProcess(cmd=['python3', 'my_launch/lag.py']),
    ])
"""
AGO_S = 2.0
EARLY = 'subtract a Duration from now, and look up only if buffer.can_transform returns True'
SAID = re.compile(r'\s*(\d+\.\d\d) (\d+\.\d\d)\s*')


def said(run: Evidence) -> list[tuple[float, str]]:
    """Return the lines that lag logged, with their times."""
    return [(log.time_s, log.message) for log in run.first.logs if log.logger == 'lag']


@check(points=1)
def it_says_something(run: Evidence) -> None:
    """lag logs once a second where turtle1 was"""
    lines = said(run)
    if not 4 <= len(lines) <= 9:
        seen = f'{len(lines)} lines in 8.5 s'
        raise Failure(
            'lag does not log once a second', seen=seen, where=run.source.place, try_='use a timer of one second, as in ask.py'
        )
    if not any(node.name == '/lag' and '/tf' in dict(node.subscriptions) for node in run.first.nodes):
        advice = 'create a Buffer and a TransformListener, as in ask.py'
        raise Failure('lag does not receive the transforms', expected='a TransformListener', where=run.source.place, try_=advice)


@check(points=1, needs=[it_says_something])
def it_says_only_that(run: Evidence) -> None:
    """lag logs no error"""
    wrong = [text for _, text in said(run) if not SAID.fullmatch(text)]
    if wrong:
        raise Failure(
            'a line of the log is not two numbers',
            expected='x y with two digits, such as 6.72 9.15',
            seen=wrong[0][:300],
            where=run.source.place,
            try_='ask buffer.can_transform whether the lookup would succeed',
        )


@check(points=2, needs=[it_says_only_that])
def it_was_there_two_seconds_ago(run: Evidence) -> None:
    """The logged position is the one of two seconds before"""
    for time_s, text in said(run):
        frame = run.first.frames_at(max(time_s - AGO_S, 0.0)).get('turtle1')
        if frame is None:
            raise Mismatch(
                f'the line of lag at {time_s:.2f} s',
                'no line, because tf2 had no transform two seconds ago',
                text,
                where=run.source.place,
                try_=EARLY,
            )
        x, y, _ = frame.translation
        numbers = [float(word) for word in text.split()]
        if not abs(numbers[0] - x) + abs(numbers[1] - y) <= 0.1:
            raise Mismatch(
                f'the line of lag at {time_s:.2f} s',
                f'{x:.2f} {y:.2f}',
                text,
                where=run.source.place,
                try_='subtract a Duration from now',
            )


RUBRIC = Rubric(
    title='Two seconds ago',
    of='my_launch/lag.py',
    launch=LAUNCH,
    scenarios=lambda random: [Scenario('run', {}, 8.5)],
    checks=[it_says_something, it_says_only_that, it_was_there_two_seconds_ago],
)
