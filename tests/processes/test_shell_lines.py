"""Lines that join commands of the simulation."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.processes.shell_lines import parts_of, with_arguments
from edulaunch.processes.spec import ProcessSpec


@pytest.mark.parametrize(
    ('line', 'parts'),
    [
        ('ros2 run a b', [('', 'ros2 run a b')]),
        (
            'sleep 2; ros2 run a b && echo done || echo failed',
            [('', 'sleep 2'), (';', 'ros2 run a b'), ('&&', 'echo done'), ('||', 'echo failed')],
        ),
        ("ros2 topic pub /a b '{x: 1; y: $(2)}' ; exec bash", [('', 'ros2 topic pub /a b {x: 1; y: $(2)}'), (';', 'bash')]),
        ('ros2 run a b;', [('', 'ros2 run a b')]),
        ('', None),
        ('ros2 run a b | grep c', None),
        ('ros2 run a b > $file', None),
        ('ros2 run a b < file', None),
        ('echo "$HOME"', None),
        ('ros2 run a b > file 2>&1 & sleep 1', [('', 'ros2 run a b'), ('&', 'sleep 1')]),
        (
            'sleep 2; sleep 1 && ros2 run a b > c & ls',
            [('', 'sleep 2'), (';', 'sh -c  sleep 1 && ros2 run a b > c '), ('&', 'ls')],
        ),
        ("ros2 run a 'b > c'>>file", [('', 'ros2 run a b > c')]),
        ("echo 'open", None),
        ('ros2 run a b\nros2 run c d', None),
    ],
)
def test_a_line_has_parts_unless_only_a_shell_understands_it(line: str, parts: list[tuple[str, str]] | None) -> None:
    found = parts_of(line)
    assert (found and [(part.joint, ' '.join(part.words)) for part in found]) == parts


def follow(world: Any, *argv: str, shell: bool = False, signal_at: float | None = None) -> list[tuple[float, str]]:
    """What a command writes, with the simulated time, and at last its exit code."""
    wrote: list[tuple[float, str]] = []
    process = world.host.start(
        ProcessSpec(argv=argv, name='line', shell=shell), lambda stream, text: wrote.append((world.sim.elapsed_s, text))
    )
    if signal_at is not None:
        world.sim.schedule(world.sim.now_ns + round(signal_at * 1e9), lambda: process.send_signal(2))
    world.sim.run()
    return [*wrote, (world.sim.elapsed_s, str(process.returncode))]


@pytest.mark.parametrize('shell', [True, False])
def test_commands_run_one_after_the_other_in_simulated_time(world: Any, shell: bool) -> None:
    first, second = (
        world.write('a.py', 'import time; time.sleep(1); print("a")'),
        world.write('b.py', 'print("b"); raise SystemExit(3)'),
    )
    line = f'sleep 2; {first} && echo "then b"; {second} && echo never || echo failed'
    words = (line,) if shell else ('bash', '-c', line)
    assert follow(world, *words, shell=shell) == [(3.0, 'a\n'), (3.0, 'then b\n'), (3.0, 'b\n'), (3.0, 'failed\n'), (3.0, '0')]


def test_output_goes_to_files_and_to_nowhere(world: Any) -> None:
    script = world.write('b.py', 'import sys; print("out"); print("err", file=sys.stderr)')
    line = f'cd {world.folder}; {script} > both 2>&1; {script} 2>> both; {script} &> /dev/null; {script}>other'
    assert [text for _, text in follow(world, line, shell=True)] == ['out\n', 'err\n', '0']
    assert ((world.folder / 'both').read_text(), (world.folder / 'other').read_text()) == ('out\nerr\nerr\n', 'out\n')


def test_a_line_goes_on_beside_a_command_and_whoever_started_it_hears_that_one_to_its_end(world: Any) -> None:
    late = world.write('late.py', 'import time; time.sleep(2); print("late")')
    text = f'import os, time; print(os.system("{late} & sleep 1 && {late} > /dev/null &")); time.sleep(1); print("on"); time.sleep(3)'
    assert world.run(text) == '0\non\nlate\n'


def test_a_line_ends_with_the_status_of_its_last_command_or_of_exit(world: Any) -> None:
    script = world.write('b.py', 'raise SystemExit(3)')
    assert follow(world, f'true; {script}', shell=True)[-1] == (0.0, '3')
    assert follow(world, f'{script}; exit 4; echo never', shell=True) == [(0.0, '4')]


def test_cd_and_export_hold_for_what_follows(world: Any) -> None:
    (world.folder / 'inner').mkdir()
    script = world.write('b.py', 'import os; print(os.path.basename(os.getcwd()), os.environ["ROBOT"])')
    assert follow(world, f'cd {world.folder}/inner && export ROBOT=r2; {script}', shell=True)[0][1] == 'inner r2\n'


def test_ctrl_c_reaches_the_command_and_ends_the_line(world: Any) -> None:
    script = world.write('b.py', 'import time\ntry:\n    time.sleep(9)\nexcept KeyboardInterrupt:\n    print("bye")')
    assert follow(world, f'{script}; echo never', shell=True, signal_at=1.0) == [(1.0, 'bye\n'), (1.0, '-2')]


def test_a_terminal_that_a_command_opens_is_not_needed(world: Any) -> None:
    script = world.write('b.py', 'print("b")')
    assert follow(world, 'gnome-terminal', '--', 'bash', '-c', f'{script}; exec bash') == [(0.0, 'b\n'), (0.0, '0')]


def test_a_line_without_simulated_commands_is_for_a_real_shell(world: Any) -> None:
    assert not world.host.knows(ProcessSpec(argv=('echo a; exit 4',), name='line', shell=True))


@pytest.mark.parametrize(
    ('line', 'expected'),
    [
        ('sleep 5; $0 $@', "sleep 5; a 'b c' d"),
        ('sleep 5; exec "$0" "$@"', "sleep 5; exec a 'b c' d"),
        ('$0 $*', "a 'b c' d"),
        ("echo '$0'", "echo '$0'"),
        ('echo "$0 x"', 'echo "a x"'),
        ('true', 'true'),
    ],
)
def test_a_line_may_name_the_words_behind_it(line: str, expected: str) -> None:
    assert with_arguments(line, ['a', 'b c', 'd']) == expected
    assert with_arguments(line, []) == line


def test_a_prefix_may_start_a_program_later(world: Any) -> None:
    script = world.write('b.py', 'import sys; print(*sys.argv[1:], sep="|")')
    assert follow(world, 'bash', '-c', 'sleep 2.5; $0 $@', str(script), 'x y', 'z') == [(2.5, 'x y|z\n'), (2.5, '0')]
