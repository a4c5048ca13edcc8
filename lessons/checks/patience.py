"""The check of lesson 11: a node that waits for a transform."""

from __future__ import annotations

import re

from edugrade import Evidence, Failure, Rubric, Scenario, check

PLACE = re.compile(r'now: -?\d+\.\d+ -?\d+\.\d+')
ADVICE = [
    'wait for the transform',
    'a timeout alone is not enough: what receives the transform while the callback waits?',
    'write rclpy.spin(node, MultiThreadedExecutor())',
]


@check(points=1)
def it_gets_an_answer(run: Evidence) -> None:
    """The lookup for now returns a position"""
    lines = [log for log in run.first.logs if log.logger == 'ask']
    answers = [log for log in lines if log.message.startswith('now:')]
    if not answers or not PLACE.fullmatch(answers[-1].message):
        seen = '\n'.join(log.message for log in lines[-3:]) or 'no log lines'
        raise Failure('/ask does not log the expected line', expected='now: 5.54 9.54', seen=seen, where=run.source.place, try_=ADVICE)
    asked = max((log.time_s for log in lines if log.message.startswith('newest:')), default=0.0)
    if not answers[-1].time_s > asked:
        raise Failure(
            'the answer for now comes at once',
            expected='an answer after the next transform of turtle1 has arrived',
            seen=f'the answer is from {answers[-1].time_s:.3f} s, the time of the question',
            where=run.source.place,
            try_='ask for now, as the file does, and wait with the argument timeout',
        )


RUBRIC = Rubric(
    title='A node that waits',
    of='my_launch/ask.launch.py',
    beside=['my_launch/ask.py'],
    scenarios=lambda random: [Scenario('run', {}, 3.2)],
    checks=[it_gets_an_answer],
)
