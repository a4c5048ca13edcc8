"""Programs that never give their turn back."""

from __future__ import annotations

import signal
import sys
import threading
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from edulaunch.engine.processes.watchdog import Watchdog

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
    assert 'RunawayProgramError: program-1 ran for too long without waiting for anything' in wrote and 'in spin\n' in wrote
    assert f'it was stopped at {watched.folder}/program-1.py:' in wrote
    assert wrote.splitlines()[-1].startswith('  help: this loop never waits')


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


NOBODY_COMES = """
    import time
    class Waits:
        seen = None
        def loop(self):
            while not self.seen:
                {body}
    time.sleep(1)
    Waits().loop()
    """


@pytest.mark.parametrize('body', ['print("waiting")', 'print("x" * 100_000)', 'import sys; sys.stderr.write("a\\nb\\n")'])
def test_who_writes_on_and_on_is_stopped_at_once_in_the_same_place(world: Any, body: str) -> None:
    """Without a watchdog: it is a matter of counting."""
    world.start(world.write('other.py', 'import time\ntime.sleep(2)\nprint("alive")'), 'other-2')
    wrote = world.run(NOBODY_COMES.format(body=body))
    assert world.codes == {'program-1': 1, 'other-2': 0}
    assert len(wrote) < 5_000_000
    assert 'times in one instant without waiting for anything; it was stopped at' in wrote[-400:]
    assert f'{world.folder}/program-1.py:7' in wrote[-400:]


def test_as_much_in_many_instants_is_nobodys_business(world: Any) -> None:
    wrote = world.run('import time\nfor _ in range(300):\n    for _ in range(100): print("x")\n    time.sleep(0.01)\n')
    assert wrote.count('x') == 30_000 and world.codes == {'program-1': 0}


def test_who_speaks_for_others_may_write_as_much_as_all_of_them(world: Any) -> None:
    child = world.write('child.py', 'for _ in range(6000): print("x")')
    wrote = world.run(
        f'import subprocess\na, b = subprocess.Popen([{child!r}]), subprocess.Popen([{child!r}])\na.wait(), b.wait()'
    )
    assert wrote.count('x') == 12_000 and world.codes == {'program-1': 0}


def limits(watchdog: Watchdog, monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Lets the processor's time of the watched thread pass by itself, 10 ms at each look; how long those had that were stopped.

    Of this one only: those of machines that other tests have left look on.
    """
    time_s, began_s, task, stopped = 0.0, 0.0, None, []
    look, end = watchdog._look, watchdog._end

    def first_look() -> Any:
        nonlocal began_s, task
        seen = look()
        if seen is None or seen.task is not task:
            began_s, task = time_s, seen and seen.task
        return seen

    def processor_s() -> float:
        nonlocal time_s
        time_s += 0.01
        return time_s

    def note(task: Any, kind: Any) -> None:
        stopped.append(round(time_s - began_s, 3))
        end(task, kind)

    for name, patched in (('_processor_s', processor_s), ('_look', first_look), ('_end', note)):
        monkeypatch.setattr(watchdog, name, patched)
    return stopped


@pytest.mark.skipif(not sys.platform.startswith('linux'), reason='/proc tells which signals a thread blocks')
def test_the_signal_of_a_long_call_is_not_for_the_watchdog(watched: Any) -> None:
    watched.run('pass')
    (thread,) = [each for each in threading.enumerate() if each.name == 'edulaunch watchdog' and is_of(each, watched)]
    status = Path(f'/proc/self/task/{thread.native_id}/status').read_text()
    blocked = int(next(line for line in status.splitlines() if line.startswith('SigBlk')).split()[1], 16)
    assert blocked >> (signal.SIGXCPU - 1) & 1


def is_of(thread: threading.Thread, watched: Any) -> bool:
    return getattr(thread, '_target', None) == watched.host.watchdog._watch


@pytest.mark.parametrize(
    'text, factor',
    [
        ('while True:\n    pass', 1),
        ('seen = None\nwhile not seen:\n    pass', 1),
        ('class A:\n    seen = 0\na = A()\nwhile not a.seen:\n    pass', 1),
        ('count = 0\nwhile True:\n    count += 1', 3),
        ('class A:\n    seen = 0\na = A()\nwhile True:\n    a.seen += 1', 3),
        ('import json\ntext = json.dumps(list(range(1000)))\nwhile True:\n    json.loads(text, parse_int=lambda x: int(x))', 3),
    ],
)
def test_where_nothing_changes_less_time_is_given(watched: Any, monkeypatch: pytest.MonkeyPatch, text: str, factor: int) -> None:
    stopped = limits(watched.host.watchdog, monkeypatch)
    watched.host.watchdog.seconds = 0.2
    watched.run(text)
    assert watched.codes == {'program-1': 1}
    assert 0.2 * factor <= stopped[0] < 0.2 * (factor + 2), 'not before its limit, and before the next one: 1, 3 or 5 times'


def test_variables_that_come_while_it_looks_at_the_others_do_not_end_it(watched: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """On a busy machine the watched thread goes on between two of them."""
    names: dict[str, Any] = {'one': 1}
    frame = SimpleNamespace(f_code=SimpleNamespace(co_filename=watched.write('own.py', '')), f_locals=names, f_back=None)
    monkeypatch.setattr(watched.host.watchdog, '_running', lambda: ('task', frame))
    monkeypatch.setattr('edulaunch.engine.processes.watchdog._held', lambda value: names.setdefault(f'new {len(names)}', value))
    seen = watched.host.watchdog._look()
    assert seen is not None and seen.state == (id(frame), 1)


def test_a_moment_without_threads_is_waited_for(world: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    watchdog = Watchdog(world.sim, 0.2)
    start, attempts, pauses = threading.Thread.start, [1, 2], []

    def starts(thread: threading.Thread) -> None:
        if attempts:
            attempts.pop()
            raise RuntimeError("can't start new thread")
        start(thread)

    monkeypatch.setattr(threading.Thread, 'start', starts)
    monkeypatch.setattr('time.sleep', pauses.append)
    watchdog.start()
    watchdog.stop()
    assert len(pauses) == 2

    attempts[:] = range(99)
    with pytest.raises(RuntimeError, match='new thread'):
        Watchdog(world.sim, 0.2).start()


@pytest.mark.skipif(not hasattr(signal, 'SIGURG'), reason='Windows cannot interrupt a call of the system')
def test_a_call_of_the_system_that_waits_for_the_outside_is_interrupted(watched: Any) -> None:
    wrote = watched.run(
        """
        import socket
        with socket.socket() as listening:
            listening.bind(('127.0.0.1', 0))
            listening.listen(1)
            listening.accept()
        """
    )
    assert watched.codes == {'program-1': 1}
    assert 'program-1 waited for too long for something outside the simulation; it was stopped at ' in wrote
    assert wrote.splitlines()[-1].startswith('  help: program-1 waits for something outside the simulation')
