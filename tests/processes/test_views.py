"""What standard modules look like from inside."""

from __future__ import annotations

from collections.abc import Callable
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
        ('import sys\nprint(sys.argv[1:], sys.stdout.isatty(), sys.version_info.major)', "['a', 'b'] False 3\n"),
        (
            'import os\nos.environ["X"] = "1"\nprint(os.getenv("X"), os.environ.get("HOME"), os.path.join("a", "b"))',
            '1 /home/student a/b\n',
        ),
        ('import uuid\nprint(uuid.uuid4().version, uuid.uuid4() == uuid.uuid4())', '4 False\n'),
        ('import threading\nprint(threading.current_thread().name, threading.active_count())', 'MainThread 1\n'),
        ('import concurrent.futures\nprint(concurrent.futures.__name__)', 'concurrent.futures\n'),
    ],
)
def test_views(world: Any, text: str, output: str) -> None:
    assert world.run(text, 'program-1', 'a', 'b') == output


def test_a_loop_that_only_looks_at_the_clock_ends(world: Any) -> None:
    assert world.run('import time\nend = time.time() + 0.5\nwhile time.time() < end:\n    pass\nprint("ended")') == 'ended\n'


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


def test_unseeded_randomness_repeats_with_the_seed_and_differs_by_name(make_world: Callable[[int], Any]) -> None:
    text = 'import random\nfrom random import randint\nprint(randint(0, 10**9), random.random(), random.Random().random())'
    first, again, other_seed = (make_world(seed).run(text) for seed in (1, 1, 2))
    assert first == again != other_seed
    assert make_world(1).run(text, 'another-2') != first


def test_the_shared_random_module_is_left_alone(world: Any) -> None:
    import random

    random.seed(5)
    expected = random.Random(5).random()
    world.run('import random\nrandom.seed(1)\nrandom.random()')
    assert random.random() == expected


def test_queues_wait_in_simulated_time(world: Any) -> None:
    assert (
        world.run("""
        import queue, threading, time
        box = queue.Queue(maxsize=1)
        def produce():
            for number in range(3):
                time.sleep(1)
                box.put(number)
        threading.Thread(target=produce, daemon=True).start()
        print([box.get() for _ in range(3)], time.monotonic())
        try:
            box.get(timeout=0.5)
        except queue.Empty:
            print('empty', time.monotonic())
        """)
        == '[0, 1, 2] 3.0\nempty 3.5\n'
    )


def test_threads_join_timers_fire_and_locals_are_apart(world: Any) -> None:
    assert (
        world.run("""
        import threading, time
        data = threading.local()
        data.who = 'main'
        def work():
            data.who = 'worker'
            time.sleep(1)
        worker = threading.Thread(target=work)
        worker.start()
        worker.join(timeout=0.25)
        print(worker.is_alive(), time.monotonic())
        worker.join()
        print(worker.is_alive(), time.monotonic(), data.who, worker.name)
        threading.Timer(2, lambda: print('timer', time.monotonic())).start()
        """)
        == 'True 0.25\nFalse 1.0 main Thread-1 (work)\ntimer 3.0\n'
    )


def test_kill_reaches_simulated_programs_only(world: Any) -> None:
    assert (
        world.run("""
        import os, signal
        try:
            os.kill(1, signal.SIGTERM)
        except ProcessLookupError as error:
            print(error)
        """)
        == '[Errno 3] No such process\n'
    )


def test_functions_of_time_are_no_methods(world: Any) -> None:
    assert world.run('import time\nclass Robot:\n    clock = time.time\nprint(Robot().clock())') == '1700000000.0\n'


def test_executors_work_in_simulated_time(world: Any) -> None:
    assert (
        world.run("""
        import time
        from concurrent.futures import ThreadPoolExecutor, as_completed
        def work(seconds):
            time.sleep(seconds)
            return seconds
        with ThreadPoolExecutor(max_workers=2) as pool:
            waiting = [pool.submit(work, seconds) for seconds in (3, 1, 1.5)]
            print([future.result() for future in as_completed(waiting)], time.monotonic())
        """)
        == '[1, 1.5, 3] 3.0\n'
    )


def test_work_of_an_executor_ends_before_the_program(world: Any) -> None:
    world.run(
        'import time\nfrom concurrent.futures import ThreadPoolExecutor\n'
        'ThreadPoolExecutor().submit(lambda: (time.sleep(5), print("worked")))\nprint("main")'
    )
    assert [(time, text) for time, _, text in world.log] == [(0.0, 'main\n'), (5.0, 'worked\n')]


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


def test_asyncio_runs_in_simulated_time(world: Any) -> None:
    assert (
        world.run("""
        import asyncio, time
        async def tick(seconds):
            await asyncio.sleep(seconds)
            print(seconds, time.monotonic())
            return seconds
        async def main():
            slept = asyncio.get_running_loop().run_in_executor(None, time.sleep, 2.5)
            print(await asyncio.gather(tick(2), tick(1)))
            await slept
        asyncio.run(main())
        asyncio.get_event_loop().run_until_complete(tick(1))
        """)
        == '1 1.0\n2 2.0\n[2, 1]\n1 3.5\n'
    )


def test_asyncio_counts_the_tasks_of_each_program_and_tells_at_its_end_what_was_left(world: Any) -> None:
    for name in ('one', 'two'):
        out = world.run(
            """
            import asyncio
            async def wait():
                print(asyncio.current_task().get_name())
                await asyncio.sleep(1000)
            loop = asyncio.new_event_loop()
            asyncio.run_coroutine_threadsafe(wait(), loop)
            loop.call_later(1.0, loop.stop)
            loop.run_forever()
            """,
            name,
        ).splitlines()
        assert out[:2] == ['Task-1', 'Task was destroyed but it is pending!']
        assert out[2].startswith("task: <Task pending name='Task-1' coro=<wait() running at ")
        assert out[2].endswith('wait_for=<Future pending cb=[Task.task_wakeup()]>>')


def test_asyncio_run_wants_a_coroutine_and_cancels_what_is_left(world: Any) -> None:
    assert (
        world.run("""
        import asyncio
        async def for_ever():
            try:
                await asyncio.sleep(1000)
            finally:
                print('cancelled')
        async def main():
            asyncio.ensure_future(for_ever())
            await asyncio.sleep(1)
        asyncio.run(main())
        try:
            asyncio.run(3)
        except ValueError as error:
            print(error)
        """)
        == 'cancelled\na coroutine was expected, got 3\n'
    )


def test_randomness_of_numpy_repeats_and_the_shared_one_is_left_alone(make_world: Callable[[int], Any]) -> None:
    import numpy

    before = numpy.random.get_state()[2]
    text = """
        import numpy as np
        from numpy.random import rand
        print(rand(2).tolist(), np.random.default_rng().random(), np.random.randint(10**6), np.random.RandomState().rand(), np.linalg.norm([3, 4]))
        """
    first, again, other_seed = (make_world(seed).run(text) for seed in (1, 1, 2))
    assert first == again != other_seed and first.endswith(' 5.0\n')
    assert numpy.random.get_state()[2] == before


def test_a_given_seed_counts(world: Any) -> None:
    import numpy

    expected = numpy.random.RandomState(3).rand()
    assert world.run('import numpy.random\nnumpy.random.seed(3)\nprint(float(numpy.random.rand()))') == f'{expected}\n'


@pytest.mark.parametrize('text', ['import secrets\nprint(secrets.token_hex(8))', 'import os\nprint(os.urandom(8).hex())'])
def test_even_the_machines_own_randomness_repeats(make_world: Callable[[int], Any], text: str) -> None:
    first, again, other_seed = (make_world(seed).run(text) for seed in (1, 1, 2))
    assert first == again != other_seed


def test_logging_is_private_and_its_stamps_are_simulated(world: Any) -> None:
    import logging

    handlers = list(logging.getLogger().handlers)
    assert (
        world.run("""
        import logging, time
        logging.basicConfig(level=logging.INFO, format='%(asctime)s %(levelname)s %(name)s %(message)s')
        time.sleep(1.5)
        logging.getLogger('robot').info('moves')
        """)
        == '2023-11-14 22:13:21,500 INFO robot moves\n'
    )
    assert logging.getLogger().handlers == handlers


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


@pytest.mark.parametrize(
    ('text', 'output'),
    [
        (
            'import pickle, datetime\nprint(pickle.loads(pickle.dumps([datetime.datetime.now(), datetime.date.today()])))',
            '[datetime.datetime(2023, 11, 14, 22, 13, 20), datetime.date(2023, 11, 14)]\n',
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
        ('import os, shutil\nprint(os.cpu_count(), shutil.get_terminal_size((70, 20)).columns)', '4 70\n'),
        ('import concurrent.futures as f\nprint(f.ThreadPoolExecutor()._max_workers)', '8\n'),
        ('import os\nos.write(1, b"out ")\nos.write(2, b"err")', 'out err'),
    ],
)
def test_more_of_the_simulated_machine(world: Any, text: str, output: str) -> None:
    assert world.run(text) == output


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


def test_asyncio_hears_signals_and_tells_what_it_cannot_do(world: Any) -> None:
    wrote = world.run("""
        import asyncio, os, signal
        async def main():
            pressed = asyncio.Event()
            loop = asyncio.get_running_loop()
            loop.add_signal_handler(signal.SIGINT, pressed.set)
            loop.call_later(2, os.kill, os.getpid(), signal.SIGINT)
            await pressed.wait()
            print('pressed', loop.time())
            await asyncio.create_subprocess_exec('ls')
        asyncio.run(main())
        """)
    assert wrote.startswith('pressed 2.0\n') and wrote.endswith(
        'RuntimeError: asyncio: subprocess_exec cannot be used in the simulation\n'
        '  help: asyncio cannot start programs here (subprocess_exec); start them with subprocess.run() or subprocess.Popen(), which wait in simulated time\n'
    )


@pytest.mark.parametrize(
    'ask',
    [
        'os.path.exists("words.txt")',
        'os.listdir() == ["words.txt"]',
        'os.path.abspath("x") == os.getcwd() + "/x"',
        'list(os.walk("."))[0] == (".", [], ["words.txt"])',
        '[e.path for e in os.scandir(".")] == ["./words.txt"]',
        '[Path(e).read_text() for e in os.scandir() if e.is_file()] == ["hello"]',
        'os.path.relpath(os.getcwd() + "/a/b") == "a/b"',
        'glob.glob("*.txt") == ["words.txt"]',
        'join("a", "b") == "a/b"',
        'os.stat("words.txt").st_size == 5',
        'Path("words.txt").read_text() == "hello"',
        'Path.cwd() == Path(os.getcwd())',
        'Path("words.txt").exists()',
        '[*Path().glob("*.txt")] == [Path("words.txt")]',
        'str(Path("x").resolve()) == os.getcwd() + "/x"',
        'io.open("words.txt").close() is None',
        'Path("words.txt").open().close() is None',
    ],
)
def test_relative_paths_are_looked_for_in_the_programs_own_folder(world: Any, ask: str) -> None:
    world.write('data/words.txt', 'hello')
    world.start(
        world.write(
            'p.py', f'import glob, io, os\nfrom os.path import join\nfrom pathlib import Path\nos.chdir("data")\nprint({ask})'
        ),
        cwd=str(world.folder),
    )
    world.sim.run()
    assert world.log[-1][2] == 'True\n'


def test_files_are_made_and_removed_in_the_programs_own_folder(world: Any) -> None:
    world.start(
        world.write(
            'p.py',
            """
        import os, shutil
        os.makedirs('a/b')
        open('a/b/file', 'w').close()
        os.rename('a/b/file', 'a/moved')
        shutil.rmtree('a/b')
        """,
        ),
        cwd=str(world.folder),
    )
    world.sim.run()
    assert world.codes == {'program-1': 0} and [path.name for path in (world.folder / 'a').iterdir()] == ['moved']


def test_home_is_that_of_the_simulated_machine(world: Any) -> None:
    assert world.run('import os\nprint(os.path.expanduser("~/maps"))') == '/home/student/maps\n'


def test_objects_of_the_programs_own_classes_can_be_pickled(world: Any) -> None:
    world.write('lib/shapes.py', 'class Square:\n    side = 2')
    assert (
        world.run("""
        import pickle
        from dataclasses import dataclass
        import shapes
        @dataclass
        class Point:
            x: int
        print(pickle.loads(pickle.dumps([Point(3), {'a': 1.5}])), pickle.loads(pickle.dumps(shapes.Square())).side)
        """)
        == "[Point(x=3), {'a': 1.5}] 2\n"
    )


def test_coroutines_run_on_the_loop_of_another_thread(world: Any) -> None:
    assert (
        world.run("""
        import asyncio, threading, time
        loop = asyncio.new_event_loop()
        thread = threading.Thread(target=loop.run_forever)
        thread.start()
        async def work(seconds):
            await asyncio.sleep(seconds)
            return 1 / (seconds - 2)
        print(asyncio.run_coroutine_threadsafe(work(1), loop).result(), time.monotonic())
        print(type(asyncio.run_coroutine_threadsafe(work(2), loop).exception()).__name__, time.monotonic())
        loop.call_soon_threadsafe(loop.stop)
        thread.join()
        """)
        == '-1.0 1.0\nZeroDivisionError 3.0\n'
    )


@pytest.mark.parametrize('name', ['pkg_resources', 'pkgutil'])
def test_what_nobody_needs_is_refused_with_a_sentence(world: Any, name: str) -> None:
    wrote = world.run(f'import {name}')
    assert f"ModuleNotFoundError: No module named '{name}'" in wrote
    assert 'use importlib.resources or ament_index_python' in wrote
