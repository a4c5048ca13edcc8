"""Your turn of lesson 11: where was turtle1 two seconds ago?"""

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
EARLY = 'now, minus a Duration, and only if buffer.can_transform'
SAID = re.compile(r'\s*(\d+\.\d+) (\d+\.\d+)\s*')


def said(run: Evidence) -> list[tuple[float, str]]:
    """What lag says, and when."""
    return [(log.time_s, log.message) for log in run.first.logs if log.logger == 'lag']


@check(points=1)
def it_says_something(run: Evidence) -> None:
    """lag says once a second where turtle1 was"""
    lines = said(run)
    if not 4 <= len(lines) <= 9:
        seen = f'{len(lines)} lines in 8.5 s'
        raise Failure(
            'lag does not say it once a second', seen=seen, where=run.source.place, try_='a timer of a second, as in ask.py'
        )


@check(points=1, needs=[it_says_something])
def it_says_only_that(run: Evidence) -> None:
    """It writes no line about an error"""
    wrong = [text for _, text in said(run) if not SAID.fullmatch(text)]
    if wrong:
        raise Failure(
            'a line is not the two numbers',
            expected='x y, such as 6.72 9.15',
            seen=wrong[0][:300],
            where=run.source.place,
            try_='buffer.can_transform says beforehand whether a lookup would work',
        )


@check(points=2, needs=[it_says_only_that])
def it_was_there_two_seconds_ago(run: Evidence) -> None:
    """turtle1 was there two seconds before"""
    for time_s, text in said(run):
        frame = run.first.frames_at(max(time_s - AGO_S, 0.0)).get('turtle1')
        if frame is None:
            raise Mismatch(
                f'what lag says at {time_s:.2f} s',
                'nothing: two seconds ago nobody knew',
                text,
                where=run.source.place,
                try_=EARLY,
            )
        x, y, _ = frame.translation
        numbers = [float(word) for word in text.split()]
        if not abs(numbers[0] - x) + abs(numbers[1] - y) <= 0.1:
            raise Mismatch(
                f'what lag says at {time_s:.2f} s', f'{x:.2f} {y:.2f}', text, where=run.source.place, try_='now, minus a Duration'
            )


RUBRIC = Rubric(
    title='Two seconds ago',
    of='my_launch/lag.py',
    launch=LAUNCH,
    scenarios=lambda random: [Scenario('run', {}, 8.5)],
    checks=[it_says_something, it_says_only_that, it_was_there_two_seconds_ago],
)
