from __future__ import annotations

from edulaunch.extras.comparing.differing import Difference
from edulaunch.extras.comparing.known import Known
from edulaunch.extras.comparing.verb import report


def test_a_report_begins_with_its_verdict_and_says_what_does_not_count() -> None:
    found = [Difference('node', '/b', 'there', 'missing')]
    slow = [Difference('rate of messages', '/t', '10 Hz', '5 Hz')]
    chance = [Difference('messages', '/dice', '3', 'none')]
    assert report(found, slow, [Known('*', 'the client was gone')], chance, {'late'}).splitlines() == [
        'The real run differs from the simulation in 1 thing:',
        'differs  of  in simulation  for real',
        'node     /b  there          missing',
        'These differences depend on the speed of this computer, and do not count:',
        '  rate of messages /t: 10 Hz in simulation, 5 Hz for real',
        'These differences are known:',
        '  the client was gone',
        'These also differ between simulations with other random numbers: messages /dice.',
        'late was stopped before it had started: its output and exit code do not count.',
    ]


def test_a_report_of_equal_runs_is_one_sentence() -> None:
    assert report([], [], [], [], set()) == 'The real run does not differ from the simulation.'
