"""How a program ends: its return code, what is still called, and who is waited for."""

from __future__ import annotations

import signal
from typing import Any

import pytest


@pytest.mark.parametrize(
    ('text', 'code', 'said'),
    [
        ('', 0, ''),
        ('import sys\nsys.exit()', 0, ''),
        ('import sys\nsys.exit(3)', 3, ''),
        ('import sys\nsys.exit(256 + 7)', 7, ''),
        ('import sys\nsys.exit(True)', 1, ''),
        ('import sys\nsys.exit("too late")', 1, 'too late\n'),
        ('raise SystemExit((1, 2))', 1, '(1, 2)\n'),
        ('import os\nprint("a")\nos._exit(4)\nprint("b")', 4, 'a\n'),
        ('import os, signal\nos.kill(os.getpid(), signal.SIGKILL)\nprint("b")', -9, ''),
        ('import os, signal\nos.kill(os.getpid(), signal.SIGTERM)\nprint("b")', -15, ''),
    ],
)
def test_the_return_code_is_that_of_python(world: Any, text: str, code: int, said: str) -> None:
    assert (world.run(text), world.codes) == (said, {'program-1': code})


def test_functions_for_the_end_are_called_last_first_after_the_threads_have_ended(world: Any) -> None:
    text = """
        import atexit, threading, time

        def late():
            time.sleep(2)
            print('thread')

        atexit.register(print, 'first registered')
        atexit.register(print, 'last', 'registered', sep=' and ')
        threading.Thread(target=late).start()
        threading.Thread(target=lambda: (time.sleep(9), print('never')), daemon=True).start()
        print('main')
        """
    world.start(world.write('a.py', text))
    world.sim.run()
    assert [(time, said.strip()) for time, _, said in world.log if said.strip()] == [
        (0.0, 'main'),
        (2.0, 'thread'),
        (2.0, 'last and registered'),
        (2.0, 'first registered'),
    ]
    assert world.codes == {'program-1': 0}


def test_an_error_in_a_function_for_the_end_is_told_and_the_others_are_called(world: Any) -> None:
    said = world.run('import atexit\natexit.register(print, "still called")\natexit.register(lambda: 1 / 0)\n')
    assert said.startswith('Exception ignored in atexit callback:\nTraceback') and said.endswith(
        'division by zero\nstill called\n'
    )
    assert world.codes == {'program-1': 0}


def test_a_killed_program_has_no_last_words(world: Any) -> None:
    text = 'import atexit, time\natexit.register(print, "no")\ntry:\n    time.sleep(9)\nfinally:\n    print("no")\n'
    process = world.start(world.write('a.py', text))
    world.sim.schedule(world.sim.now_ns + 10**9, lambda: process.send_signal(signal.SIGKILL))
    world.sim.run()
    assert (world.log, world.codes, process.lifecycle.killed_by) == ([], {'program-1': -9}, 9)
    assert process.lifecycle.is_dead and world.sim.elapsed_s == 1.0


@pytest.mark.parametrize(('signum', 'code'), [(signal.SIGINT, -2), (signal.SIGTERM, -15), (signal.SIGKILL, -9)])
def test_a_signal_before_the_first_turn_ends_the_program(world: Any, signum: int, code: int) -> None:
    process = world.start(world.write('a.py', 'print("never")'))
    process.send_signal(signum)
    world.sim.run()
    assert ([said for *_, said in world.log if 'never' in said], world.codes) == ([], {'program-1': code})


def test_what_is_to_be_done_at_the_end_is_done_once_also_after_an_error(world: Any) -> None:
    log: list[object] = []
    process = world.start(world.write('a.py', 'raise ValueError("x")'))
    process.lifecycle.at_exit.append(lambda: log.append(process.lifecycle.is_dead))
    world.sim.run()
    assert (log, world.codes, process.lifecycle.is_dead) == ([False], {'program-1': 1}, True)
