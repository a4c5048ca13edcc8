"""Keyboards, signals and screens inside."""

from __future__ import annotations

from typing import Any


def test_input_reads_the_given_lines_then_ends(world: Any) -> None:
    wrote = world.run(
        """
        print(input('name? '), input())
        try:
            input()
        except EOFError as error:
            print(error)
        """,
        'asks-1',
    )
    assert wrote == 'name? first line second line\nEOF when reading a line\n'


KEYS = """
    import select, sys, termios, time, tty
    settings = termios.tcgetattr(sys.stdin)
    def get_key():
        tty.setraw(sys.stdin.fileno())
        ready, _, _ = select.select([sys.stdin], [], [], 0.5)
        key = sys.stdin.read(1) if ready else ''
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
        return key
    """


def test_scripted_keys_are_read_one_by_one_then_nobody_presses_any(world: Any) -> None:
    assert (
        world.run(
            KEYS
            + """
    print(''.join(get_key() for _ in range(23)).split(), time.monotonic())
    print(repr(get_key()), time.monotonic())
        """,
            'asks-1',
        )
        == "['first', 'line', 'second', 'line'] 0.0\n'' 0.5\n"
    )


def test_reading_a_keyboard_that_nobody_presses_waits(world: Any) -> None:
    process = world.start(world.write('p.py', 'import sys, tty\ntty.setcbreak(sys.stdin)\nprint("waits")\nsys.stdin.read(1)'))
    world.sim.run(world.sim.now_ns + 10**9)
    process.send_signal(2)
    world.sim.run()
    assert world.codes == {'program-1': -2} and world.log[0][2] == 'waits\n'


def test_reading_at_the_end_of_a_file_again_and_again_lets_time_pass(world: Any) -> None:
    world.start(world.write('p.py', 'import sys\nwhile not sys.stdin.read(1):\n    pass'))
    world.sim.run(world.sim.now_ns + 10**9)
    assert world.sim.elapsed_s == 1.0


def test_there_is_no_screen(world: Any) -> None:
    wrote = world.run('from turtle import position, Turtle\nprint("imported")\nTurtle()')
    assert wrote.startswith('imported\n') and 'no display name' in wrote and 'the simulated machine has no screen' in wrote


def test_alarms_ring_in_simulated_time(world: Any) -> None:
    assert (
        world.run("""
        import signal, time
        signal.signal(signal.SIGALRM, lambda number, frame: print('rings', time.monotonic()))
        signal.alarm(2)
        time.sleep(3)
        signal.setitimer(signal.ITIMER_REAL, 0.5, 0.25)
        time.sleep(0.8)
        print(signal.alarm(0))
        time.sleep(5)
        """)
        == 'rings 2.0\nrings 3.5\nrings 3.75\n1\n'
    )


def test_an_abort_and_an_unhandled_alarm_end_a_program_by_their_signals(world: Any) -> None:
    world.run('import os\nos.abort()', 'aborts')
    world.run('import signal, time\nsignal.alarm(1)\ntime.sleep(5)', 'rings')
    assert world.codes == {'aborts': -6, 'rings': -14}
