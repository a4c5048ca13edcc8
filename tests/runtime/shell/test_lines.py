"""Lines that join commands of the simulation."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.runtime.shell.grammar import parsed


@pytest.mark.parametrize(
    'line',
    [
        '',
        '  # nothing',
        "echo 'open",
        'echo "open',
        'if true; then echo; fi',
        'for x in a b; do echo; done',
        '(echo a)',
        'cat <<EOF',
        'echo $((1 + 1))',
        'f() { echo; }',
        '${x%y} a',
        'echo a >',
        'a && ',
        '| b',
        'a ;; b',
        'echo $(',
        '[[ a ]]',
    ],
)
def test_what_is_not_in_the_grammar_is_for_a_real_shell(line: str) -> None:
    assert parsed(line) is None


@pytest.mark.parametrize(
    ('line', 'out'),
    [
        ('show a "b c" d\\ e', "['a', 'b c', 'd e']"),
        ('show $NAME "$NAME" ${NAME} \'$NAME\' $NIX "$NIX"', "['two', 'words', 'two words', 'two', 'words', '$NAME', '']"),
        ('show ${NIX:-other} ${NAME:-x}y', "['other', 'two', 'wordsy']"),
        ('X=1 Y="$NAME"; show $X-$Y', "['1-two', 'words']"),
        ('show "{x: 1; y: $(echo 2)}" `echo 3`', "['{x: 1; y: 2}', '3']"),
        ('show x$(show a)/y', '["x[\'a\']/y"]'),
        ('show $(show a | cat)', '["[\'a\']"]'),
        ('show *.txt n*pe "*.txt" ?.txt', "['a.txt', 'b.txt', 'n*pe', '*.txt', 'a.txt', 'b.txt']"),
        ('show ~ ~/x a~', "['/home/student', '/home/student/x', 'a~']"),
        ('false; show $?', "['1']"),
        ('show a # and a remark', "['a']"),
        ('show a#b', "['a#b']"),
        ('true &&\nshow a', "['a']"),
        ('show "a\\$b" \'c"d\'', "['a$b', 'c\"d']"),
    ],
)
def test_words_are_those_of_a_shell(world: Any, line: str, out: str) -> None:
    show = world.write('show.py', 'import sys; print(sys.argv[1:])')
    for name in ('a.txt', 'b.txt'):
        (world.folder / name).write_text('')
    text = f'cd {world.folder}; export NAME="two words"; {line.replace("show", str(show))}'
    assert [said for _, said in follow(world, text, shell=True)] == [f'{out}\n', '0']


@pytest.mark.parametrize(
    ('pipe', 'out'),
    [
        ('grep -i B', ['b1', 'b2']),
        ('grep -v b | grep -n .', ['1:a']),
        ('grep -c b', ['2']),
        ('grep -o [12]', ['1', '2']),
        ("grep -E '^(a|b2)$'", ['a', 'b2']),
        ('head -n 2', ['a', 'b1']),
        ('head -1', ['a']),
        ('tail -1', ['b2']),
        ('sort -r | head -1', ['b2']),
        ('wc -l', ['3']),
        ('tr ab xy', ['x', 'y1', 'y2']),
        ('cat | uniq | cat', ['a', 'b1', 'b2']),
        ('grep nothing || echo none', ['none']),
    ],
)
def test_text_goes_through_pipes(world: Any, pipe: str, out: list[str]) -> None:
    script = world.write('three.py', 'print("a\\nb1\\nb2")')
    assert ''.join(said for _, said in follow(world, f'{script} | {pipe}', shell=True)[:-1]).splitlines() == out


def test_text_comes_through_as_it_is_written_and_head_ends_what_never_ends(world: Any) -> None:
    script = world.write('ever.py', 'import time\nn = 0\nwhile True:\n    n += 1\n    print(n)\n    time.sleep(1)')
    assert follow(world, f'{script} | grep -v 2 | head -2; echo over', shell=True) == [
        (0.0, '1\n'),
        (2.0, '3\n'),
        (2.0, 'over\n'),
        (2.0, '0'),
    ]


def test_a_program_reads_what_another_one_or_a_file_gives(world: Any) -> None:
    script = world.write('twice.py', 'import sys\nfor line in sys.stdin: print(line.strip() * 2)')
    (world.folder / 'words').write_text('ab\n')
    line = f'cd {world.folder}; echo xy | {script} | {script}; {script} < words; echo z | {script} > out; cat out'
    assert [said for _, said in follow(world, line, shell=True)] == ['xyxyxyxy\n', 'abab\n', 'zz\n', '0']


def test_a_missing_command_and_a_missing_folder_are_told_as_a_shell_tells_them(world: Any) -> None:
    script = world.write('b.py', 'print("b")')
    assert [said for _, said in follow(world, f'nix || {script}; cd /nowhere && {script}', shell=True)] == [
        'sh: nix: not found\n',
        'b\n',
        'sh: cd: /nowhere: No such file or directory\n',
        '1',
    ]


def test_ctrl_c_reaches_every_command_of_a_pipe(world: Any) -> None:
    script = world.write(
        'b.py', 'import sys, time\ntry:\n    time.sleep(9)\nexcept KeyboardInterrupt:\n    print("bye", flush=True)'
    )
    assert follow(world, f'{script} | grep -v x; echo never', shell=True, signal_at=1.0) == [(1.0, 'bye\n'), (1.0, '-2')]


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


def test_a_prefix_may_start_a_program_later(world: Any) -> None:
    script = world.write('b.py', 'import sys; print(*sys.argv[1:], sep="|")')
    assert follow(world, 'bash', '-c', 'sleep 2.5; $0 "$@"', str(script), 'x y', 'z') == [(2.5, 'x y|z\n'), (2.5, '0')]
    assert follow(world, 'bash', '-c', '$0 $@; echo $# "$1"', str(script), 'x y', 'z')[0][1] == 'x|y|z\n'
