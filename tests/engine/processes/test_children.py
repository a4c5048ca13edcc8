"""Programs that programs start."""

from __future__ import annotations

from typing import Any

import pytest

CHILD = """
    import sys, time
    time.sleep(2)
    print('said', sys.argv[1:], sys.stdin.read())
    print('error', file=sys.stderr)
    sys.exit(3)
    """


@pytest.mark.parametrize(
    ('call', 'output'),
    [
        ('subprocess.run([CHILD, "a"]).returncode', "said ['a'] \nerror\n3 2.0\n"),
        ('subprocess.run([CHILD], capture_output=True, text=True, input="x").stdout', 'said [] x\n 2.0\n'),
        ('subprocess.run([CHILD], stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout', "b'said [] \\nerror\\n' 2.0\n"),
        ('subprocess.call([CHILD], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)', '3 2.0\n'),
        ('subprocess.getstatusoutput(CHILD)', "(3, 'said [] \\nerror') 2.0\n"),
        ('os.system(CHILD + " a")', "said ['a'] \nerror\n768 2.0\n"),
        ('os.popen(CHILD).read()', 'error\nsaid [] \n 2.0\n'),
        (
            'list(subprocess.Popen([CHILD], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout)',
            "['said [] \\n'] 2.0\n",
        ),
    ],
)
def test_a_known_program_runs_in_the_simulation(world: Any, call: str, output: str) -> None:
    child = world.write('child.py', CHILD)
    assert (
        world.run(f'import os, subprocess, time\nCHILD = {child!r}\nresult = {call}\nprint(result, time.monotonic())') == output
    )


def test_lines_of_a_child_are_read_one_by_one(world: Any) -> None:
    child = world.write('child.py', r"print('\nsecond\nlast', end='')")
    program = f'import subprocess\nout = subprocess.Popen([{child!r}], stdout=subprocess.PIPE, text=True).stdout\n'
    assert world.run(program + 'print([out.readline() for _ in range(4)])') == "['\\n', 'second\\n', 'last', '']\n"


def test_waiting_has_a_limit_and_a_child_can_be_stopped(world: Any) -> None:
    child = world.write('child.py', CHILD)
    assert (
        world.run(f"""
        import subprocess, time
        child = subprocess.Popen([{child!r}])
        try:
            child.wait(timeout=0.5)
        except subprocess.TimeoutExpired as error:
            print(error.timeout, child.poll())
        child.terminate()
        print(child.wait(), time.monotonic())
        try:
            subprocess.run([{child!r}], check=True, capture_output=True)
        except subprocess.CalledProcessError as error:
            print(error.returncode)
        """)
        == '0.5 None\n-15 0.5\n3\n'
    )


def test_a_real_program_that_is_waited_for_takes_no_simulated_time(world: Any) -> None:
    assert (
        world.run("""
        import subprocess, time
        subprocess.run('echo shown; exit 4', shell=True)
        print(subprocess.check_output(['printf', 'x']), time.monotonic())
        try:
            subprocess.run(['no-such-command-here'])
        except FileNotFoundError:
            print('not found')
        """)
        == "shown\nb'x' 0.0\nnot found\n"
    )


def test_what_a_child_writes_is_recorded_once_and_not_when_it_is_captured(world: Any) -> None:
    recorded: list[tuple[str, str]] = []
    world.host.tracer.output = lambda process, stream, text: recorded.append((process.name, text))
    child = world.write('child.py', 'print("said")')
    world.run(f'import subprocess\nsubprocess.run([{child!r}])\nsubprocess.run([{child!r}], capture_output=True)')
    assert recorded == [('program-1', 'said\n')]
