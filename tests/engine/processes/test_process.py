"""How programs begin, take signals and end."""

from __future__ import annotations

import signal
from typing import Any

import pytest

from edulaunch.engine.graph.qos import QoS

DEFAULT = 'signal.signal(signal.SIGINT, signal.SIG_DFL)'
PRINT_FOREVER = 'import time\nwhile True:\n    time.sleep(1)\n    print("tick")\n'


@pytest.mark.parametrize(
    ('text', 'code', 'output'),
    [
        ('print("done")', 0, 'done\n'),
        ('import sys\nsys.exit(3)', 3, ''),
        ('import sys\nsys.exit(256)', 0, ''),
        ('import sys\nsys.exit(-1)', 255, ''),
        ('import sys\nsys.exit(True)', 1, ''),
        ('import sys\nsys.exit("bad luck")', 1, 'bad luck\n'),
        ('raise SystemExit', 0, ''),
        ('exit(4)', 4, ''),
        ('import os\nos._exit(-1)', 255, ''),
        ('import os\ntry:\n    os._exit(5)\nfinally:\n    print("not printed")', 5, ''),
    ],
)
def test_exit_codes_are_those_of_python(world: Any, text: str, code: int, output: str) -> None:
    wrote = world.run(text)
    assert world.codes == {'program-1': code}
    assert wrote == output


def test_an_uncaught_exception_shows_only_the_students_frames(world: Any) -> None:
    wrote = world.run('def spin():\n    return 1 / 0\n\nspin()\n')
    assert wrote == (
        f'Traceback (most recent call last):\n  File "{world.folder}/program-1.py", line 4, in <module>\n    spin()\n'
        f'  File "{world.folder}/program-1.py", line 2, in spin\n    return 1 / 0\n'
        'ZeroDivisionError: division by zero\n'
    )
    assert world.codes == {'program-1': 1}


def test_a_misspelt_message_field_gets_a_line_of_help(world: Any) -> None:
    wrote = world.run('from geometry_msgs.msg import Twist\nTwist().linaer = 1\n')
    assert (
        wrote.endswith('  help: Twist has no field linaer; its fields are linear, angular; write linear\n')
        and "'Twist' object has no attribute 'linaer'" in wrote
    )


def test_processes_take_turns_in_simulated_time(world: Any) -> None:
    script = world.write(
        'tick.py', 'import sys, time\nfor _ in range(2):\n    time.sleep(float(sys.argv[1]))\n    print("tick")\n'
    )
    world.start(script, 'slow-1', '1.0')
    world.start(script, 'fast-2', '0.4')
    world.sim.run()
    assert [(time, who) for time, who, _ in world.log] == [(0.4, 'fast-2'), (0.8, 'fast-2'), (1.0, 'slow-1'), (2.0, 'slow-1')]
    assert world.codes == {'fast-2': 0, 'slow-1': 0}


def test_sigint_is_a_keyboard_interrupt_where_the_program_waits(world: Any) -> None:
    process = world.start(
        world.write(
            'p.py',
            """
        import time
        try:
            time.sleep(100)
        except KeyboardInterrupt:
            print('tidied up')
        """,
        )
    )
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


@pytest.mark.parametrize('signum', [signal.SIGTERM, signal.SIGKILL])
def test_a_killed_program_says_and_publishes_nothing_in_its_finally_blocks(world: Any, signum: int) -> None:
    process = world.start(
        world.write(
            'p.py',
            """
        import rclpy, time
        from rclpy.signals import SignalHandlerOptions
        from std_msgs.msg import String
        rclpy.init(signal_handler_options=SignalHandlerOptions.NO)
        node = rclpy.create_node('talker')
        publisher = node.create_publisher(String, 'chatter', 10)
        try:
            time.sleep(100)
        except:
            print('everything is caught')
        finally:
            publisher.publish(String(data='last words'))
            node.get_logger().info('last words')
            raise SystemExit(3)
        """,
        )
    )
    node = world.host.graph.add_node(None, 'listener', '/')
    from std_msgs.msg import String

    heard = world.host.graph.create_subscription(node, '/chatter', String, QoS(), lambda: None)
    world.sim.schedule(world.sim.now_ns + 10**9, lambda: process.send_signal(signum))
    world.sim.run()
    assert (world.log, list(heard.queue), world.codes) == ([], [], {'program-1': -signum})


def test_daemon_threads_end_with_the_program_without_a_word(world: Any) -> None:
    assert (
        world.run("""
        import threading, time
        def work():
            try:
                time.sleep(100)
            finally:
                print('not reached')
        threading.Thread(target=work, daemon=True).start()
        time.sleep(1)
        """)
        == ''
    )


def test_with_the_default_action_ctrl_c_kills(world: Any) -> None:
    process = world.start(
        world.write(
            'p.py',
            """
        import signal, time
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        try:
            time.sleep(100)
        finally:
            print('not reached')
        """,
        )
    )
    world.sim.schedule(world.sim.now_ns + 10**9, lambda: process.send_signal(signal.SIGINT))
    world.sim.run()
    assert (world.log, world.codes) == ([], {'program-1': -2})


@pytest.mark.parametrize(
    ('first', 'second', 'said', 'code'),
    [('rclpy.init()', DEFAULT, '', -2), (DEFAULT, 'rclpy.init()', 'shut down\n', 0), ('rclpy.init()', '', 'interrupted\n', 0)],
)
def test_rclpy_puts_itself_in_the_place_of_the_default_action(world: Any, first: str, second: str, said: str, code: int) -> None:
    process = world.start(
        world.write(
            'p.py',
            f"""
        import rclpy, signal
        from rclpy.executors import ExternalShutdownException
        {first}
        {second}
        try:
            rclpy.spin(rclpy.create_node('n'))
        except KeyboardInterrupt:
            print('interrupted')
        except ExternalShutdownException:
            print('shut down')
        """,
        )
    )
    world.sim.schedule(world.sim.now_ns + 10**9, lambda: process.send_signal(signal.SIGINT))
    world.sim.run()
    assert (''.join(text for *_, text in world.log), world.codes) == (said, {'program-1': code})


@pytest.mark.parametrize('send', ['os.kill(os.getpid(), signal.SIGINT)', 'signal.raise_signal(signal.SIGINT)'])
def test_a_signal_to_itself_is_taken_at_once(world: Any, send: str) -> None:
    assert (
        world.run(f"""
        import os, signal
        try:
            {send}
            print('not reached')
        except KeyboardInterrupt:
            print('interrupted')
        """)
        == 'interrupted\n'
    )


@pytest.mark.parametrize(
    ('install', 'words'),
    [
        ('signal.signal(signal.SIGKILL, print)', 'OSError [Errno 22] Invalid argument'),
        (
            'signal.signal(signal.SIGINT, "stop")',
            'TypeError signal handler must be signal.SIG_IGN, signal.SIG_DFL, or a callable object',
        ),
        ('in_thread()', 'ValueError signal only works in main thread of the main interpreter'),
    ],
)
def test_a_handler_that_cannot_be_is_refused_as_by_python(world: Any, install: str, words: str) -> None:
    assert (
        world.run(f"""
        import signal
        from concurrent.futures import ThreadPoolExecutor
        def in_thread():
            ThreadPoolExecutor().submit(signal.signal, signal.SIGINT, print).result()
        try:
            {install}
        except Exception as error:
            print(type(error).__name__, error)
        """)
        == f'{words}\n'
    )


def test_a_handler_is_told_where_the_program_stood(world: Any) -> None:
    process = world.start(
        world.write(
            'p.py',
            """
        import signal, time
        def stop(number, frame):
            print(frame.f_code.co_name)
        def wait():
            time.sleep(3)
        signal.signal(signal.SIGINT, stop)
        wait()
        """,
        )
    )
    world.sim.schedule(world.sim.now_ns + 10**9, lambda: process.send_signal(signal.SIGINT))
    world.sim.run()
    assert world.log == [(1.0, 'program-1', 'wait\n')]


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
    process = world.start(
        world.write(
            'p.py',
            """
        import signal, sys, time
        def stop(number, frame):
            print('got', number)
            sys.exit(7)
        signal.signal(signal.SIGTERM, stop)
        while True:
            time.sleep(1)
        """,
        )
    )
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
    assert (
        world.run("""
        import atexit, threading, time
        atexit.register(print, 'first registered')
        atexit.register(print, 'last registered')
        threading.Thread(target=lambda: (time.sleep(1), print('thread'))).start()
        print('main')
        """)
        == 'main\nthread\nlast registered\nfirst registered\n'
    )


def test_an_exit_without_cleaning_up_calls_nothing(world: Any) -> None:
    assert world.run('import atexit, os\natexit.register(print, "called")\nos._exit(3)') == ''
    assert world.codes == {'program-1': 3}


def test_a_program_has_its_own_folder(world: Any) -> None:
    world.write('data/words.txt', 'hello')
    script = world.write(
        'p.py',
        'import os\nwith open("words.txt") as file:\n    print(os.getcwd(), file.read())\nos.chdir("..")\nprint(os.path.basename(os.getcwd()))',
    )
    world.start(script, cwd=str(world.folder / 'data'))
    world.sim.run()
    assert ''.join(text for *_, text in world.log) == f'{world.folder}/data hello\n{world.folder.name}\n'


def test_bytes_can_be_written_too(world: Any) -> None:
    assert (
        world.run('import sys\nsys.stdout.buffer.write("grüße\\n".encode())\nsys.stdout.reconfigure(line_buffering=True)')
        == 'grüße\n'
    )
