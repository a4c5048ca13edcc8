"""`threading` from inside a program."""

from __future__ import annotations

from typing import Any

import pytest


def test_a_started_thread_runs_up_to_where_it_waits_before_its_starter_goes_on(world: Any) -> None:
    assert (
        world.run("""
        import threading, time
        def work():
            print('thread')
            time.sleep(1)
            print('thread again')
        threading.Thread(target=work).start()
        print('main')
        """)
        == 'thread\nmain\nthread again\n'
    )


def test_a_barrier_lets_all_go_and_breaks_when_one_waits_too_long(world: Any) -> None:
    assert (
        world.run("""
        import threading, time
        gate = threading.Barrier(2)
        threading.Thread(target=lambda: (time.sleep(2), gate.wait(), print('late', time.monotonic()))).start()
        gate.wait()
        print('main', time.monotonic(), gate.broken)
        try:
            gate.wait(0.5)
        except threading.BrokenBarrierError:
            print('broken', time.monotonic(), gate.broken)
        """)
        == 'late 2.0\nmain 2.0 False\nbroken 2.5 True\n'
    )


def test_a_class_of_thread_local_data_begins_anew_in_each_thread(world: Any) -> None:
    assert (
        world.run("""
        import threading
        class Data(threading.local):
            def __init__(self, start):
                self.count = start
        data = Data(5)
        data.count += 1
        threading.Thread(target=lambda: print(data.count, data.__dict__)).start()
        del data.count
        print(hasattr(data, 'count'))
        """)
        == "5 {'count': 5}\nFalse\n"
    )


@pytest.mark.parametrize(
    ('text', 'output'),
    [
        (
            'thread = Thread(target=print, name="t", daemon=True)\nprint(thread)\nthread.start()\nthread.join()\nprint(thread, thread.native_id)',
            '<Thread(t, initial daemon)>\n\n<Thread(t, stopped daemon 1001001)> 1001001\n',
        ),
        ('print(threading.main_thread())', '<_MainThread(MainThread, started 1001000)>\n'),
        (
            'threading.excepthook = lambda args: print(args.thread.name, args.exc_type.__name__)\nThread(target=lambda: 1 / 0, name="t").start()',
            't ZeroDivisionError\n',
        ),
        ('Thread(target=lambda: print(Thread().daemon), daemon=True).start()', 'True\n'),
    ],
)
def test_threads_look_as_they_do_in_python(world: Any, text: str, output: str) -> None:
    assert world.run(f'import threading\nfrom threading import Thread\n{text}') == output


def test_other_processes_are_refused_with_a_sentence(world: Any) -> None:
    wrote = world.run('import multiprocessing\nprint(multiprocessing.cpu_count())\nmultiprocessing.Process(target=print).start()')
    assert wrote.startswith('4\n') and wrote.endswith(
        'RuntimeError: multiprocessing.Process cannot be used: the simulation cannot copy a running program\n'
        '  help: multiprocessing.Process needs another process, but the simulation cannot copy a running program; '
        'use Thread, queue.Queue or ThreadPoolExecutor, which work in simulated time\n'
    )
