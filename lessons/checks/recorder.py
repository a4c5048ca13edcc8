"""The check of lesson 15: a recorder that starts only on request."""

from __future__ import annotations

from edugrade import Evidence, Mismatch, Rubric, Scenario, check
from edugrade.library.arguments import require_default

TOPICS = ('/tf', '/tf_static')


def recorders(run: Evidence, scenario: str) -> list[list[str]]:
    """Return the words of the commands that record."""
    words = [' '.join(process.argv).split() for process in run[scenario].processes]
    return [each for each in words if 'bag' in each and 'record' in each]


def nothing_is_recorded(run: Evidence) -> None:
    """In each run there is no recorder."""
    for scenario in run:
        if found := recorders(run, scenario):
            raise Mismatch('the recorder', 'none', ' '.join(found[0]), where=run.source.place, try_='use a condition, lesson 4')


@check(points=1)
def record_is_declared(run: Evidence) -> None:
    """The launch argument record has the default false"""
    require_default(run, 'record', 'false', nothing_is_recorded)


@check(points=1)
def nothing_is_recorded_untold(run: Evidence) -> None:
    """With record:=false, no recorder starts"""
    nothing_is_recorded(run.only(['untold']))


@check(points=2)
def it_is_recorded_when_told(run: Evidence) -> None:
    """With record:=true, a recorder writes /tf and /tf_static into my_launch/fleet_bag"""
    found = recorders(run, 'told')
    if len(found) != 1 or not all(word in found[0] for word in (*TOPICS, 'my_launch/fleet_bag')):
        seen = '\n'.join(' '.join(words) for words in found) or 'no recorder'
        raise Mismatch(
            'the recorder',
            'one for /tf and /tf_static, with the bag my_launch/fleet_bag',
            seen,
            where=run.source.place,
            try_='use ros2 bag record, section 15.1',
        )


RUBRIC = Rubric(
    title='A black box for the fleet',
    decoys=1.0,  # the recorder is a command and no Node, so a decoy with idle nodes still has it
    of='my_launch/black_box.launch.py',
    scenarios=lambda random: [
        Scenario('told', {'record': 'true'}, 1.0),
        Scenario('untold', {}, 1.0, defaults={'record': 'false'}),
    ],
    checks=[record_is_declared, nothing_is_recorded_untold, it_is_recorded_when_told],
)
