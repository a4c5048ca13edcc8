"""os and sys inside: the simulated machine."""

from __future__ import annotations

import signal
from pathlib import Path
from typing import Any

import pytest


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


def test_home_is_that_of_the_simulated_machine(world: Any) -> None:
    assert world.run('import os\nprint(os.path.expanduser("~/maps"))') == '/home/student/maps\n'


@pytest.mark.parametrize(
    ('text', 'output'),
    [
        ('import sys\nprint(sys.argv[1:], sys.stdout.isatty(), sys.version_info.major)', "['a', 'b'] False 3\n"),
        (
            'import os\nos.environ["X"] = "1"\nprint(os.getenv("X"), os.environ.get("HOME"), os.path.join("a", "b"))',
            '1 /home/student a/b\n',
        ),
        ('import os, shutil\nprint(os.cpu_count(), shutil.get_terminal_size((70, 20)).columns)', '4 70\n'),
        ('import os\nos.write(1, b"out ")\nos.write(2, b"err")', 'out err'),
    ],
)
def test_arguments_variables_and_streams_are_those_of_the_simulated_machine(world: Any, text: str, output: str) -> None:
    assert world.run(text, 'program-1', 'a', 'b') == output


def test_functions_of_atexit_are_called_when_the_program_ends_and_are_its_own(world: Any) -> None:
    lines = ['import atexit', 'atexit.register(print, "last")', 'atexit.register(print, "first")']
    lines.append('atexit.unregister(atexit.register(lambda: print("never")))')
    assert world.run('\n'.join(lines)) == 'first\nlast\n'


@pytest.mark.parametrize(
    ('expression', 'value'),
    [
        ('os.system("exit 3")', str(3 << 8)),
        ('os.system("true")', '0'),
        ('os.system("kill -9 $$") & 127', '9'),
        ('os.popen("echo one two").read()', "'one two\\n'"),
        ('os.popen("exit 2").close()', str(2 << 8)),
        ('os.popen("true").close()', 'None'),
        ('[os.isatty(fd) for fd in (0, 1, 2)]', '[False, False, False]'),
        ('(len(os.urandom(5)), os.urandom(8) != os.urandom(8))', '(5, True)'),
    ],
)
def test_shell_lines_end_with_the_status_that_the_system_gives(world: Any, expression: str, value: str) -> None:
    assert world.run(f'import os\nprint(repr({expression}))') == f'{value}\n'


def test_numbers_of_files_that_are_no_streams_are_real_files(world: Any, tmp_path: Path) -> None:
    file = tmp_path / 'file'
    lines = [f'fd = os.open({str(file)!r}, os.O_RDWR | os.O_CREAT)', 'os.write(fd, b"text")', 'os.lseek(fd, 1, 0)']
    assert world.run('\n'.join(['import os', *lines, 'print(os.read(fd, 2), os.isatty(fd))'])) == "b'ex' False\n"
    assert file.read_text() == 'text'


@pytest.mark.parametrize(
    'call',
    [
        'os.execl("python3", "python3", path, "a")',
        'os.execlpe("python3", "python3", path, "a", {**os.environ, "WHO": "other"})',
        'os.execv(sys.executable, ["python3", path, "a"])',
        'os.execve("python3", ["python3", path, "a"], {"WHO": "other"})',
    ],
)
def test_a_program_that_replaces_itself_becomes_the_other_one(world: Any, call: str) -> None:
    other = world.write(
        'other.py',
        'import os, sys, time\nprint(sys.argv[1:], os.environ.get("WHO"))\n'
        'try:\n    time.sleep(60)\nexcept KeyboardInterrupt:\n    sys.exit(3)\n',
    )
    text = f'import os, sys\npath = {str(other)!r}\ntry:\n    {call}\nfinally:\n    print("not printed")\n'
    process = world.start(world.write('first.py', text), 'program-1')
    world.sim.run(world.sim.start_ns + 10**9)
    process.send_signal(signal.SIGINT)
    world.sim.run()
    assert [line for _, _, line in world.log] == [f"['a'] {'other' if 'other' in call else None}\n"]
    assert world.codes == {'program-1': 3} and world.sim.elapsed_s == 1.0


def test_a_group_of_programs_is_killed_with_all_its_children(world: Any) -> None:
    waits = world.write('waits.py', 'import time\ntime.sleep(60)\n')
    shell = world.write('shell.py', f'import subprocess\nsubprocess.run(["python3", {str(waits)!r}])\n')
    text = """
        import os, signal, subprocess, time
        child = subprocess.Popen(["python3", SHELL], preexec_fn=os.setsid)
        time.sleep(1)
        os.killpg(os.getpgid(child.pid), signal.SIGTERM)
        print(child.wait(), os.getpgid(0) == os.getpgrp() == os.getpid())
        try:
            os.killpg(99999, signal.SIGTERM)
        except ProcessLookupError as error:
            print(error)
        os.killpg(0, signal.SIGTERM)
    """
    assert world.run(text.replace('SHELL', repr(str(shell)))) == '-15 True\n[Errno 3] No such process\n'
    assert world.codes == {'program-1': -signal.SIGTERM} and world.host.processes == []
