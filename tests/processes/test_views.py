"""What standard modules look like from inside."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest


@pytest.mark.parametrize(('text', 'output'), [
    ('import time\nprint(time.time(), time.monotonic())\ntime.sleep(1.5)\nprint(time.time_ns())', '1700000000.0 0.0\n1700000001500000000\n'),
    ('from time import sleep, time\nsleep(2)\nprint(time())', '1700000002.0\n'),
    ('import time\nprint(time.strftime("%Y-%m-%d %H:%M"), time.localtime().tm_min)', '2023-11-14 22:13 13\n'),
    ('import datetime\nprint(datetime.datetime.now())', '2023-11-14 22:13:20\n'),
    ('from datetime import datetime, timedelta\nt = datetime.now()\nprint(isinstance(t, datetime), (t + timedelta(1)).day)', 'True 15\n'),
    ('import sys\nprint(sys.argv[1:], sys.stdout.isatty(), sys.version_info.major)', "['a', 'b'] False 3\n"),
    ('import os\nos.environ["X"] = "1"\nprint(os.getenv("X"), os.environ.get("HOME"), os.path.join("a", "b"))', '1 /home/student a/b\n'),
    ('import uuid\nprint(uuid.uuid4().version, uuid.uuid4() == uuid.uuid4())', '4 False\n'),
    ('import threading\nprint(threading.current_thread().name, threading.active_count())', 'MainThread 1\n'),
    ('import concurrent.futures\nprint(concurrent.futures.__name__)', 'concurrent.futures\n'),
])
def test_views(world: Any, text: str, output: str) -> None:
    assert world.run(text, 'program-1', 'a', 'b') == output


def test_a_loop_that_only_looks_at_the_clock_ends(world: Any) -> None:
    assert world.run('import time\nend = time.time() + 0.5\nwhile time.time() < end:\n    pass\nprint("ended")') == 'ended\n'


def test_input_reads_the_given_lines_then_ends(world: Any) -> None:
    wrote = world.run("""
        print(input('name? '), input())
        try:
            input()
        except EOFError as error:
            print(error)
        """, 'asks-1')
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
    assert world.run("""
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
        """) == '[0, 1, 2] 3.0\nempty 3.5\n'


def test_threads_join_timers_fire_and_locals_are_apart(world: Any) -> None:
    assert world.run("""
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
        """) == 'True 0.25\nFalse 1.0 main Thread-1 (work)\ntimer 3.0\n'


def test_kill_reaches_simulated_programs_only(world: Any) -> None:
    assert world.run("""
        import os, signal
        try:
            os.kill(1, signal.SIGTERM)
        except ProcessLookupError as error:
            print(error)
        """) == '[Errno 3] No such process\n'
