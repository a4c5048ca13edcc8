"""Reading waits in simulated time: the others go on meanwhile."""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import Any

import pytest

TICKS = 'import time\nfor _ in range(3):\n    time.sleep(1)\n    print("tick")\n'
ASKS = 'while True:\n    try:\n        print("got", input("? "))\n    except EOFError as error:\n        print(error)\n        break\n'


def told(world: Any) -> list[tuple[float, str]]:
    return [(time, text) for time, _, text in world.log]


def test_the_next_line_comes_at_its_time_and_others_go_on(world: Any) -> None:
    world.host._stdin['asks-1'] = [(2.5, 'two\n'), (0.5, 'one\n')]
    world.start(world.write('tick.py', TICKS), 'ticks-2')
    world.start(world.write('ask.py', ASKS), 'asks-1')
    world.sim.run()
    assert told(world) == [
        (0.0, '? '),
        (0.5, 'got one\n'),
        (0.5, '? '),
        (1.0, 'tick\n'),
        (2.0, 'tick\n'),
        (2.5, 'got two\n'),
        (2.5, '? '),
        (2.5, 'EOF when reading a line\n'),
        (3.0, 'tick\n'),
    ]


@pytest.mark.parametrize(
    'loop', ['for line in sys.stdin:', 'for line in iter(sys.stdin.readline, ""):', 'while line := sys.stdin.readline():']
)
def test_lines_of_stdin_are_read_one_by_one(world: Any, loop: str) -> None:
    world.host._stdin['program-1'] = [(1.0, 'a\nb'), (2.0, '\n')]
    assert world.run(f'import sys, time\n{loop}\n    print(line.strip(), time.monotonic())') == 'a 1.0\nb 2.0\n'


def test_select_sees_the_next_key_when_it_is_pressed(world: Any) -> None:
    world.host._stdin['program-1'] = [(0.75, 'w'), (3.0, 'q')]
    assert (
        world.run("""
        import os, select, sys, time, tty
        tty.setcbreak(sys.stdin.fileno())
        key = ''
        while key != 'q':
            ready, _, _ = select.select([sys.stdin], [], [], 1.0)
            key = os.read(sys.stdin.fileno(), 8).decode() if ready else ''
            print(repr(key), time.monotonic())
        """)
        == "'w' 0.75\n'' 1.75\n'' 2.75\n'q' 3.0\n"
    )


def test_a_keyboard_that_does_not_block_gives_nothing(world: Any) -> None:
    world.host._stdin['program-1'] = [(1.0, 'x')]
    assert (
        world.run("""
        import fcntl, os, sys, termios, time
        termios.tcsetattr(sys.stdin, termios.TCSANOW, [0, 0, 0, 0, 0, 0, [b''] * 32])
        fcntl.fcntl(sys.stdin, fcntl.F_SETFL, fcntl.fcntl(sys.stdin, fcntl.F_GETFL) | os.O_NONBLOCK)
        first = sys.stdin.read(1)
        time.sleep(1)
        print(repr(first), repr(sys.stdin.read(1)))
        """)
        == "'' 'x'\n"
    )


def test_while_a_person_types_the_others_go_on(world: Any) -> None:
    reading, writing = os.pipe()
    with os.fdopen(reading, encoding='utf-8') as keyboard:
        world.host._stdin['asks-1'] = keyboard
        ticker = world.start(world.write('tick.py', TICKS.replace('(1)', '(0.02)')), 'ticks-2')
        ticker.on_exit = lambda code: (os.write(writing, 'grün\nrot'.encode()), os.close(writing))
        world.start(world.write('ask.py', ASKS), 'asks-1')
        world.sim.run()
    texts = [text for _, text in told(world)]
    assert texts[:4] == ['? ', 'tick\n', 'tick\n', 'tick\n']
    assert texts[4:] == ['got grün\n', '? ', 'got rot\n', '? ', 'EOF when reading a line\n']


def test_what_no_operating_system_knows_is_read_line_by_line(world: Any) -> None:
    world.host._stdin['program-1'] = io.StringIO('a\nb\n')
    assert world.run('import sys\nprint(sys.stdin.read(3).split(), sys.stdin.readlines())') == "['a', 'b'] ['\\n']\n"


def test_a_child_reads_what_is_written_to_it(world: Any) -> None:
    script = world.write('child.py', 'import time\nfor _ in range(2):\n    print(input(), time.monotonic())\n')
    assert (
        world.run(f"""
        import subprocess, time
        child = subprocess.Popen([{script!r}], stdin=subprocess.PIPE, text=True)
        child.stdin.write('early\\n')
        time.sleep(2)
        print(child.communicate('late\\n'))
        """)
        == 'early 0.0\nlate 2.0\n(None, None)\n'
    )


READS = [
    'input()',
    'import sys\nsys.stdin.read()',
    'import sys\nfor line in sys.stdin: pass',
    'import sys\nsys.stdin.buffer.readline()',
    'import os\nos.read(0, 1)',
]


@pytest.mark.parametrize('text', READS)
def test_a_program_of_a_launch_waits_for_ever_for_its_input(world: Any, text: str) -> None:
    """As under the real `ros2 launch`, whose pipe nobody closes; without one it reads an empty file."""
    path = world.write('p.py', f'print("asks")\n{text}\nprint("read")')
    piped = world.start(path, 'piped-1', has_pipe=True)
    world.start(path, 'plain-2')
    world.sim.run(world.sim.now_ns + 10**12)
    assert [who for _, who, said in world.log if said == 'asks\n'] == ['piped-1', 'plain-2']
    assert [who for _, who, said in world.log if said == 'read\n'] == (['plain-2'] if text != 'input()' else [])
    assert piped.returncode is None and 'plain-2' in world.codes
    piped.send_signal(2)
    world.sim.run(world.sim.now_ns + 1)
    assert world.codes['piped-1'] == -2


def test_select_on_the_pipe_times_out(world: Any) -> None:
    world.start(
        world.write('p.py', 'import select, sys, time\nprint(select.select([sys.stdin], [], [], 2.0), time.monotonic())'),
        has_pipe=True,
    )
    world.sim.run(world.sim.now_ns + 10**12)
    assert world.log[0][2] == '([], [], []) 2.0\n'


LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess
def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', {script!r}], name='game')])
"""


def test_after_a_launch_one_is_told_what_waits_for_input(tmp_path: Path) -> None:
    import edulaunch

    (tmp_path / 'child.py').write_text('input("name? ")')
    (tmp_path / 'game.py').write_text(f'import subprocess\nsubprocess.run(["python3", "{tmp_path}/child.py"])')
    (tmp_path / 'a.launch.py').write_text(LAUNCH.format(script=str(tmp_path / 'game.py')))
    recording = edulaunch.run(tmp_path / 'a.launch.py', duration_s=5.0)
    assert recording.duration_s == 5.0 and recording.processes[1].returncode is None
    assert [(fact.kind, fact.process) for fact in recording.facts] == [('waits for input', 'game-1')]
    assert [line.partition(' (')[0] for line in recording.warnings] == [
        'game-1 waits for keyboard input, which it cannot receive'
    ]


def test_stdin_answers_as_a_pipe_does(world: Any) -> None:
    text = 'import sys\nprint(*(getattr(sys.stdin, name)() for name in ("fileno", "readable", "writable", "isatty")))'
    assert world.run(text) == '0 True False False\n'


def test_stdin_is_read_line_by_line_as_bytes_and_as_text(world: Any) -> None:
    world.host._stdin['program-1'] = [(1.0, 'a\nb\nc\n'), (2.0, 'd\né\n')]
    text = """
        import sys
        print(next(sys.stdin), sys.stdin.buffer.readline(), list(zip(range(1), sys.stdin.buffer)))
        print(sys.stdin.read(1), sys.stdin.buffer.read(), list(sys.stdin))
        try:
            next(sys.stdin)
        except StopIteration:
            print('over')
        """
    assert world.run(text) == "a\n b'b\\n' [(0, b'c\\n')]\nd b'\\n\\xc3\\xa9\\n' []\nover\n"


def test_a_file_as_input_is_no_terminal_and_has_no_size(world: Any) -> None:
    text = """
        import os
        try:
            os.get_terminal_size(0)
        except OSError as error:
            print(error.errno, error.strerror)
        """
    assert world.run(text) == '25 Inappropriate ioctl for device\n'
