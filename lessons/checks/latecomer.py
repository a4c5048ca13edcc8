"""The check of lesson 18, your turn: one notice, and a reader that starts after it."""

from __future__ import annotations

from edugrade import Evidence, Failure, Mismatch, Rubric, Scenario, check
from edugrade.library.heard import Program, require_heard
from edugrade.library.node_graph import require_started

NOTICE = 'the ferry leaves at five'
LATE_S = 1.5
ADVICE = [
    'check the durability',
    'which program keeps the notice, and which one asks for old messages?',
    'write durability=DurabilityPolicy.TRANSIENT_LOCAL at both ends',
]


@check(points=1)
def it_is_read(run: Evidence) -> None:
    """The reader receives the notice although it starts two seconds later"""
    late = require_started(run, 'run', '/reader', 'leave notice.launch.py as it is')
    require_heard(run, 'run', Program('/reader'), Program('/harbour'), 'leave the names of nodes and topics as they are')
    notices = run.first.messages('/notice') if '/notice' in run.first.topics else []
    if len(notices) != 1 or not late >= notices[0][0] + LATE_S:
        times = ', '.join(f'{time_s:.2f} s' for time_s, _ in notices) or 'never'
        raise Mismatch(
            'the time of the notice',
            f'once, two seconds before the reader starts at {late:.2f} s',
            times,
            where=run.source.place,
            try_='publish one notice at the beginning, as before',
        )
    asks = [end.qos[2] for end in run.first.ends if (end.kind, end.name, end.node) == ('subscription', '/notice', '/reader')]
    if 'transient_local' not in asks:
        raise Mismatch('the durability of the reader', 'transient_local', ', '.join(asks), where=run.source.place, try_=ADVICE)
    lines = [log.message for log in run.first.logs if log.logger == 'reader']
    if NOTICE not in lines:
        seen = '\n'.join(lines[-3:]) or 'no log lines'
        raise Failure('/reader does not log the expected line', expected=NOTICE, seen=seen, where=run.source.place, try_=ADVICE)


RUBRIC = Rubric(
    title='A reader that starts late',
    of='my_launch/notice.launch.py',
    beside=['my_launch/notice.py'],
    scenarios=lambda random: [Scenario('run', {}, 5.0)],
    checks=[it_is_read],
)
