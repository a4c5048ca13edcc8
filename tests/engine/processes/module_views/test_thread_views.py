"""threading, queue and concurrent.futures inside."""

from __future__ import annotations

from typing import Any

import pytest


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


@pytest.mark.parametrize(
    ('text', 'output'),
    [
        ('import threading\nprint(threading.current_thread().name, threading.active_count())', 'MainThread 1\n'),
        ('import concurrent.futures\nprint(concurrent.futures.__name__)', 'concurrent.futures\n'),
        ('import concurrent.futures as f\nprint(f.ThreadPoolExecutor()._max_workers)', '8\n'),
    ],
)
def test_threads_and_pools_have_the_names_and_numbers_of_python(world: Any, text: str, output: str) -> None:
    assert world.run(text) == output
