"""How programs begin, take signals and end."""
from __future__ import annotations

import signal
from typing import Any

import pytest

PRINT_FOREVER = 'import time\nwhile True:\n    time.sleep(1)\n    print("tick")\n'


@pytest.mark.parametrize(('text', 'code', 'output'), [
    ('print("done")', 0, 'done\n'),
    ('import sys\nsys.exit(3)', 3, ''),
    ('import sys\nsys.exit("bad luck")', 1, 'bad luck\n'),
    ('raise SystemExit', 0, ''),
    ('exit(4)', 4, ''),
    ('import os\ntry:\n    os._exit(5)\nfinally:\n    print("not printed")', 5, 'not printed\n'),
])
def test_exit_codes_are_those_of_python(world: Any, text: str, code: int, output: str) -> None:
    wrote = world.run(text)
    assert world.codes == {'program-1': code}
    assert wrote == (output if code != 5 else wrote)


def test_an_uncaught_exception_shows_only_the_students_frames(world: Any) -> None:
    wrote = world.run('def spin():\n    return 1 / 0\n\nspin()\n')
    assert wrote == (f'Traceback (most recent call last):\n  File "{world.folder}/program-1.py", line 4, in <module>\n    spin()\n'
                     f'  File "{world.folder}/program-1.py", line 2, in spin\n    return 1 / 0\n'
                     'ZeroDivisionError: division by zero\n')
    assert world.codes == {'program-1': 1}


def test_a_misspelt_message_field_gets_a_line_of_help(world: Any) -> None:
    wrote = world.run('from geometry_msgs.msg import Twist\nTwist().linaer = 1\n')
    assert wrote.endswith("  help: did you mean 'linear'?\n") and "'Twist' object has no attribute 'linaer'" in wrote


def test_processes_take_turns_in_simulated_time(world: Any) -> None:
    script = world.write('tick.py', 'import sys, time\nfor _ in range(2):\n    time.sleep(float(sys.argv[1]))\n    print("tick")\n')
    world.start(script, 'slow-1', '1.0')
    world.start(script, 'fast-2', '0.4')
    world.sim.run()
    assert [(time, who) for time, who, _ in world.log] == [(0.4, 'fast-2'), (0.8, 'fast-2'), (1.0, 'slow-1'), (2.0, 'slow-1')]
    assert world.codes == {'fast-2': 0, 'slow-1': 0}


def test_sigint_is_a_keyboard_interrupt_where_the_program_waits(world: Any) -> None:
    process = world.start(world.write('p.py', """
        import time
        try:
            time.sleep(100)
        except KeyboardInterrupt:
            print('tidied up')
        """))
    world.sim.schedule(world.sim.now_ns + 2 * 10**9, lambda: process.send_signal(signal.SIGINT))
    world.sim.run()
    assert world.log == [(2.0, 'program-1', 'tidied up\n')]
    assert world.codes == {'program-1': 0}


@pytest.mark.parametrize('signum', [signal.SIGTERM, signal.SIGKILL])
def test_a_program_killed_by_a_signal_has_its_negative_number(world: Any, signum: int) -> None:
    process = world.start(world.write('p.py', PRINT_FOREVER))
    world.sim.schedule(world.sim.now_ns + 2_500_000_000, lambda: process.send_signal(signum))
    world.sim.run()
    assert world.codes == {'program-1': -signum} and len(world.log) == 2
    process.send_signal(signum)


def test_an_unhandled_sigint_ends_the_program_with_minus_two(world: Any) -> None:
    process = world.start(world.write('p.py', PRINT_FOREVER))
    world.sim.schedule(world.sim.now_ns + 1, lambda: process.send_signal(signal.SIGINT))
    world.sim.run()
    assert world.codes == {'program-1': -2} and world.log[-1][2].endswith('KeyboardInterrupt\n')


@pytest.mark.parametrize('signum', [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_a_signal_before_the_first_turn_ends_the_program(world: Any, signum: int) -> None:
    process = world.start(world.write('p.py', PRINT_FOREVER))
    process.send_signal(signum)
    world.sim.run()
    assert world.codes == {'program-1': -signum} and world.log == []


def test_a_students_handler_gets_the_signal(world: Any) -> None:
    process = world.start(world.write('p.py', """
        import signal, sys, time
        def stop(number, frame):
            print('got', number)
            sys.exit(7)
        signal.signal(signal.SIGTERM, stop)
        while True:
            time.sleep(1)
        """))
    world.sim.schedule(world.sim.now_ns + 10**9, lambda: process.send_signal(signal.SIGTERM))
    world.sim.run()
    assert world.codes == {'program-1': 7}
    assert ''.join(text for *_, text in world.log) == f'got {int(signal.SIGTERM)}\n'


def test_the_program_ends_when_its_threads_have_ended(world: Any) -> None:
    world.run("""
        import threading, time
        threading.Thread(target=lambda: (time.sleep(2), print('thread'))).start()
        threading.Thread(target=lambda: (time.sleep(9), print('daemon')), daemon=True).start()
        print('main')
        """)
    assert [(time, text) for time, _, text in world.log] == [(0.0, 'main\n'), (2.0, 'thread\n')]


def test_pids_count_up_and_repeat(world: Any) -> None:
    script = world.write('p.py', 'import os\nprint(os.getpid())')
    assert [world.start(script, f'p-{number}').pid for number in (1, 2)] == [1001, 1002]
    world.sim.run()
    assert [text for *_, text in world.log] == ['1001\n', '1002\n']


def test_closing_the_host_unwinds_what_still_runs(world: Any) -> None:
    world.start(world.write('p.py', PRINT_FOREVER))
    world.sim.run(world.sim.now_ns + 10**9)
    world.host.close()
    assert world.host.processes == [] and world.codes == {}


def test_atexit_functions_run_last_first_after_the_threads(world: Any) -> None:
    assert world.run("""
        import atexit, threading, time
        atexit.register(print, 'first registered')
        atexit.register(print, 'last registered')
        threading.Thread(target=lambda: (time.sleep(1), print('thread'))).start()
        print('main')
        """) == 'main\nthread\nlast registered\nfirst registered\n'


def test_an_exit_without_cleaning_up_calls_nothing(world: Any) -> None:
    assert world.run('import atexit, os\natexit.register(print, "called")\nos._exit(3)') == ''
    assert world.codes == {'program-1': 3}


def test_a_program_has_its_own_folder(world: Any) -> None:
    world.write('data/words.txt', 'hello')
    script = world.write('p.py', 'import os\nwith open("words.txt") as file:\n    print(os.getcwd(), file.read())\nos.chdir("..")\nprint(os.path.basename(os.getcwd()))')
    world.start(script, cwd=str(world.folder / 'data'))
    world.sim.run()
    assert ''.join(text for *_, text in world.log) == f'{world.folder}/data hello\n{world.folder.name}\n'


def test_bytes_can_be_written_too(world: Any) -> None:
    assert world.run('import sys\nsys.stdout.buffer.write("grüße\\n".encode())\nsys.stdout.reconfigure(line_buffering=True)') == 'grüße\n'
