"""The check of lesson 14, your turn: a client that waits for its service."""

from __future__ import annotations

from edugrade import Evidence, Failure, Rubric, Scenario, check

LAUNCH = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        ExecuteProcess(cmd=['python3', 'my_launch/clean.py']),
        TimerAction(period=1.0, actions=[Node(package='turtlesim', executable='turtlesim_node', name='sim')]),
    ])
"""


@check(points=2)
def turtle1_is_removed(run: Evidence) -> None:
    """The client calls /kill once, for turtle1, and gets a reply"""
    calls = [call.request.name for call in run.first.service_calls if call.service == '/kill' and call.served]
    if calls != ['turtle1']:
        raise Failure(
            'the calls of /kill are not the expected ones',
            expected='one call, for turtle1',
            seen=f'calls with a reply for {", ".join(calls)}' if calls else 'no call with a reply',
            where=run.source.place,
            try_=[
                'use a client of the service',
                'follow the three steps of two_more.py: create the client, wait, call',
                'node.create_client(Kill, "kill")',
            ],
        )


@check(points=1, needs=[turtle1_is_removed])
def it_says_so(run: Evidence) -> None:
    """Then it logs the line gone"""
    said = [log.message for log in run.first.logs if log.logger == 'clean']
    answered_s = max(call.replied_s or 0.0 for call in run.first.service_calls if call.service == '/kill')
    early = [log for log in run.first.logs if log.logger == 'clean' and log.message == 'gone' and log.time_s < answered_s]
    if early:
        raise Failure(
            'clean logs gone before turtle1 is gone',
            expected=f'the line after the reply of /kill at {answered_s:.2f} s',
            seen=f'the line at {early[0].time_s:.2f} s',
            where=run.source.place,
            try_='write the log line after spin_until_future_complete',
        )
    if said[-1:] != ['gone']:
        raise Failure(
            'the last line of the log is different',
            expected='gone',
            seen='\n'.join(said) or 'no line',
            where=run.source.place,
            try_="write node.get_logger().info('gone')",
        )


RUBRIC = Rubric(
    title='A client that waits',
    of='my_launch/clean.py',
    launch=LAUNCH,
    scenarios=lambda random: [Scenario('run', {}, 5.0)],
    checks=[turtle1_is_removed, it_says_so],
)
