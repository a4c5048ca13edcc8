"""Programs that never give their turn back."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.processes.watchdog import Watchdog

STUCK = """
    import time
    time.sleep(1)
    def spin():
        count = 0
        while True:
            count += 1
            try:
                count += 1
            except Exception:
                pass
    """


@pytest.fixture
def watched(world: Any) -> Any:
    world.host.watchdog = Watchdog(world.sim, 0.2)
    yield world
    world.host.close()


def test_it_is_stopped_where_it_is_and_the_others_go_on(watched: Any) -> None:
    watched.start(watched.write('other.py', 'import time\ntime.sleep(2)\nprint("alive")'), 'other-2')
    wrote = watched.run(STUCK + '\n    spin()\n')
    assert watched.codes == {'program-1': 1, 'other-2': 0}
    assert 'RunawayProgramError: program-1 kept its turn for 0.2 s of real time' in wrote and 'in spin\n' in wrote
    assert f'it was stopped at {watched.folder}/program-1.py:' in wrote and wrote.splitlines()[-1].startswith(
        '  help: a loop must wait'
    )


def test_a_thread_that_is_stuck_ends_its_program(watched: Any) -> None:
    watched.run(STUCK + '\n    import threading\n    threading.Thread(target=spin).start()\n    time.sleep(100)\n')
    assert watched.codes == {'program-1': 1}


def test_a_program_that_works_for_long_in_many_turns_is_left_alone(watched: Any) -> None:
    watched.run('import time\nfor _ in range(3000):\n    sum(range(5000))\n    time.sleep(0.001)\n')
    assert watched.codes == {'program-1': 0}


def test_it_waits_for_people(watched: Any) -> None:
    import io
    import time as real_time

    class Slow(io.StringIO):
        def readline(self, *_: Any) -> str:
            real_time.sleep(0.5)
            return 'typed\n'

    watched.host._stdin = {'program-1': Slow()}
    assert watched.run('print(input())') == 'typed\n'
