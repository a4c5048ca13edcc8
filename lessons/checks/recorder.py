"""Lesson 15: a recorder, but only when told."""

from __future__ import annotations

from edugrade import Evidence, Mismatch, Rubric, Scenario, check
from edugrade.library.arguments import require_default

TOPICS = ('/tf', '/tf_static')


def recorders(run: Evidence, scenario: str) -> list[list[str]]:
    """The words of the commands that record."""
    words = [' '.join(process.argv).split() for process in run[scenario].processes]
    return [each for each in words if 'bag' in each and 'record' in each]


@check(points=1)
def record_is_declared(run: Evidence) -> None:
    """The launch argument record is declared, by default false"""
    require_default(run, 'record', 'false')


@check(points=1)
def nothing_is_recorded_untold(run: Evidence) -> None:
    """Nothing is recorded when nobody asks for it"""
    if found := recorders(run, 'untold'):
        raise Mismatch('what is started', 'nothing', ' '.join(found[0]), where=run.source.place, try_='a condition, lesson 4')


@check(points=2)
def it_is_recorded_when_told(run: Evidence) -> None:
    """record:=true keeps /tf and /tf_static in my_launch/fleet_bag"""
    found = recorders(run, 'told')
    if len(found) != 1 or not all(word in found[0] for word in (*TOPICS, 'my_launch/fleet_bag')):
        seen = '\n'.join(' '.join(words) for words in found) or 'no recorder is started'
        raise Mismatch(
            'the recorder',
            'one, of /tf and /tf_static, into my_launch/fleet_bag',
            seen,
            where=run.source.place,
            try_='ros2 bag record, lesson 15.1',
        )


RUBRIC = Rubric(
    title='A black box for the fleet',
    of='my_launch/black_box.launch.py',
    scenarios=lambda random: [Scenario('told', {'record': 'true'}, 1.0), Scenario('untold', {'record': 'false'}, 1.0)],
    checks=[record_is_declared, nothing_is_recorded_untold, it_is_recorded_when_told],
)
