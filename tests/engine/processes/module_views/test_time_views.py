"""time, datetime and sched inside: the clock of the simulation."""

from __future__ import annotations

from typing import Any

import pytest


@pytest.mark.parametrize(
    ('text', 'output'),
    [
        (
            'import time\nprint(time.time(), time.monotonic())\ntime.sleep(1.5)\nprint(time.time_ns())',
            '1700000000.0 0.0\n1700000001500000000\n',
        ),
        ('from time import sleep, time\nsleep(2)\nprint(time())', '1700000002.0\n'),
        ('import time\nprint(time.strftime("%Y-%m-%d %H:%M"), time.localtime().tm_min)', '2023-11-14 22:13 13\n'),
        ('import datetime\nprint(datetime.datetime.now())', '2023-11-14 22:13:20\n'),
        (
            'from datetime import datetime, timedelta\nt = datetime.now()\nprint(isinstance(t, datetime), (t + timedelta(1)).day)',
            'True 15\n',
        ),
        (
            'from datetime import datetime, date\nprint([datetime(2020, 1, 2), datetime.now() + (datetime.now() - datetime(2020, 1, 1)) * 0, date(2020, 1, 2)])',
            '[datetime.datetime(2020, 1, 2, 0, 0), datetime.datetime(2023, 11, 14, 22, 13, 20), datetime.date(2020, 1, 2)]\n',
        ),
        (
            'import datetime\nprint(datetime.datetime.fromtimestamp(3600), datetime.date.fromtimestamp(0))',
            '1970-01-01 01:00:00 1970-01-01\n',
        ),
        (
            'import time\nprint(time.clock_gettime(time.CLOCK_MONOTONIC), time.clock_gettime_ns(time.CLOCK_REALTIME))',
            '0.0 1700000000000000000\n',
        ),
        ('import time\nprint(time.mktime(time.localtime()) - time.time())', '0.0\n'),
    ],
)
def test_all_clocks_are_the_simulations(world: Any, text: str, output: str) -> None:
    assert world.run(text) == output


def test_a_loop_that_only_looks_at_the_clock_ends(world: Any) -> None:
    assert world.run('import time\nend = time.time() + 0.5\nwhile time.time() < end:\n    pass\nprint("ended")') == 'ended\n'


def test_functions_of_time_are_no_methods(world: Any) -> None:
    assert world.run('import time\nclass Robot:\n    clock = time.time\nprint(Robot().clock())') == '1700000000.0\n'


def test_sched_runs_events_in_simulated_time(world: Any) -> None:
    assert (
        world.run("""
        import sched, time
        plan = sched.scheduler(time.time, time.sleep)
        plan.enter(2, 1, print, ('two',))
        plan.enter(1, 1, print, ('one',))
        plan.run()
        print(time.monotonic())
        """)
        == 'one\ntwo\n2.0\n'
    )


def test_the_time_zone_is_utc_whatever_this_computer_has(world: Any) -> None:
    told = world.run(
        'import time\nprint(time.timezone, time.altzone, time.daylight, time.tzname, time.localtime() == time.gmtime())'
    )
    assert told == "0 0 0 ('UTC', 'UTC') True\n"
