"""The check of lesson 14: a newcomer that checks whether it got its name."""

from __future__ import annotations

from edugrade import Evidence, Mismatch, Rubric, Scenario, check

ERROR = 40  # as in rcl_interfaces/msg/Log
LAUNCH = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node

PROGRAM = ['python3', 'my_launch/newcomer.py', '--ros-args', '-p', 'me:=turtle3']


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        ExecuteProcess(cmd=PROGRAM),
        ExecuteProcess(cmd=PROGRAM),
    ])
"""


def said(run: Evidence) -> list[str]:
    """Return the lines that both programs logged."""
    return sorted(log.message for log in run.first.logs if log.logger == 'newcomer')


@check(points=1)
def the_first_is_there(run: Evidence) -> None:
    """If two newcomers request the name turtle3, one of them logs: here is turtle3"""
    places = {(call.request.x, call.request.y) for call in run.first.service_calls if call.service == '/spawn' and call.served}
    if places - {(2.0, 2.0)}:
        seen = ', '.join(f'({x:g}, {y:g})' for x, y in sorted(places))
        raise Mismatch('the position in the request', '(2, 2)', seen, where=run.source.place, try_='set x and y of the request')
    if said(run).count('here is turtle3') != 1:
        raise Mismatch(
            'the log of both',
            'once: here is turtle3',
            '\n'.join(said(run)) or 'nothing',
            where=run.source.place,
            try_='follow the steps of two_more.py, and log the result',
        )


@check(points=1, needs=[the_first_is_there])
def the_second_finds_no_place(run: Evidence) -> None:
    """The other one logs: no place for turtle3"""
    errors = [log.message for log in run.first.logs if log.logger == 'newcomer' and log.level >= ERROR]
    if said(run) == ['here is turtle3', 'no place for turtle3'] and errors != ['no place for turtle3']:
        seen = 'the line has another level, or another line has this level'
        advice = 'use the method error of the logger for this line, and info for the other one'
        raise Mismatch('the level of the line', 'an error', seen, where=run.source.place, try_=advice)
    if said(run) != ['here is turtle3', 'no place for turtle3']:
        raise Mismatch(
            'the log of both',
            'here is turtle3\nno place for turtle3',
            '\n'.join(said(run)),
            where=run.source.place,
            try_='check which name the response contains when the name is in use',
        )


RUBRIC = Rubric(
    title='A newcomer',
    of='my_launch/newcomer.py',
    launch=LAUNCH,
    scenarios=lambda random: [Scenario('run', {}, 3.0)],
    checks=[the_first_is_there, the_second_finds_no_place],
)
