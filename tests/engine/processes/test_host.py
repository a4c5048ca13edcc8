"""The machine of a simulation: whom it starts, with which number and input, and what is left when it is closed."""

from __future__ import annotations

import os
from types import SimpleNamespace
from typing import Any

import pytest

from edulaunch.engine.processes.inputs import Input, SilentPipe, TypedInput
from edulaunch.engine.processes.spec import ProcessSpec


def test_numbers_start_at_1001_in_the_order_of_the_starts(world: Any) -> None:
    script = world.write('say.py', 'import os\nprint(os.getpid())\n')
    started = [world.start(script, name) for name in ('one-1', 'two-2')]
    assert [process.pid for process in started] == [1001, 1002] and world.host.processes == started
    world.sim.run()
    assert [(name, text) for _, name, text in world.log] == [('one-1', '1001\n'), ('two-2', '1002\n')]
    assert (world.host.processes, world.codes) == ([], {'one-1': 0, 'two-2': 0})


@pytest.mark.parametrize(
    ('given', 'spec', 'text'),
    [
        ({'ask-1': 'a'}, {'name': 'ask-1'}, 'a'),
        ({'ask': 'b'}, {'name': 'ask-1'}, 'b'),
        ({'key': 'c'}, {'name': 'ask-1', 'executable': 'key'}, 'c'),
        ({'ask': 'b', 'ask-1': 'a', 'key': 'c'}, {'name': 'ask-1', 'executable': 'key'}, 'a'),
        ({'key': 'c'}, {'name': 'ask-1'}, ''),
    ],
)
def test_an_input_is_chosen_by_the_launch_name_then_without_its_number_then_by_the_program(
    world: Any, given: dict[str, str], spec: dict[str, str], text: str
) -> None:
    world.host._stdin, world.host.unread_stdin = given, list(given)
    found = world.host.stdin_for(ProcessSpec(argv=('x',), **spec))
    assert (type(found), found.read()) == (Input, text)
    assert sorted(world.host.unread_stdin) == sorted(name for name, value in given.items() if value != text)


def test_an_input_may_be_typed_and_without_one_a_pipe_waits_and_a_file_is_empty(world: Any) -> None:
    world.host._stdin = {'typed': [(1.0, 'a')]}
    kinds = [type(world.host.stdin_for(ProcessSpec(argv=('x',), name=name))) for name in ('typed', 'typed-7', 'other')]
    assert kinds == [TypedInput, TypedInput, Input]
    assert type(world.host.stdin_for(ProcessSpec(argv=('x',), has_pipe=True))) is SilentPipe


def test_a_program_starts_others_from_its_own_folder_and_they_find_its_packages(world: Any) -> None:
    (world.folder / 'sub').mkdir()
    child = world.write('child.py', 'import os\nprint(os.getcwd())\n')
    parent = world.write(
        'parent.py', f'import subprocess\nsubprocess.run([{child!r}])\nsubprocess.run([{child!r}], cwd="deep")\n'
    )
    (world.folder / 'sub/deep').mkdir()
    world.start(parent, cwd=str(world.folder / 'sub'))
    world.sim.run()
    assert [text for *_, text in world.log] == [f'{world.folder}/sub\n', f'{world.folder}/sub/deep\n']


def test_a_command_that_is_not_there_is_an_error_of_the_system(world: Any) -> None:
    spec = ProcessSpec(argv=('/no/such/program',))
    assert not world.host.knows(spec)
    with pytest.raises(FileNotFoundError):
        world.host.start(spec)


def test_closing_ends_everything_without_simulated_time_and_without_reports(world: Any) -> None:
    log: list[str] = []
    text = 'import threading, time\nthreading.Thread(target=time.sleep, args=(9,)).start()\ntry:\n    time.sleep(9)\nfinally:\n    print("no")\n'
    process = world.start(world.write('sleep.py', text))
    world.host.real_programs.append(SimpleNamespace(kill=lambda: log.append('killed')))
    world.host.generated_files['a'] = SimpleNamespace(remove=lambda: log.append('removed'))
    world.sim.run(world.sim.now_ns + 10**9)
    world.host.close()
    assert (log, world.log, world.codes) == (['killed', 'removed'], [], {})
    assert process.lifecycle.task.finished and all(thread.finished for thread in process.lifecycle.threads)
    assert (world.host.processes, world.sim.elapsed_s) == ([], 1.0)


def test_a_parameter_file_is_read_from_the_folder_of_the_program_unless_launch_has_made_it(world: Any) -> None:
    path = world.write('a.yaml', 'talker:\n  ros__parameters:\n    rate: 2\n')
    assert [(entry.name, entry.value) for entry in world.host.parameter_entries(path)] == [('rate', 2)]
    world.host.generated_files['made'] = SimpleNamespace(entries=lambda: ['entry'], remove=lambda: None)
    assert world.host.parameter_entries('made') == ['entry']
    with pytest.raises(FileNotFoundError):
        world.host.parameter_entries(os.path.join(world.folder, 'b.yaml'))


def test_what_packages_add_is_found_once_and_forgotten_when_no_program_uses_it(world: Any) -> None:
    indexes = [SimpleNamespace(**dict.fromkeys(('packages', 'python_modules'), dict), interface_roots=list) for _ in range(2)]
    mine, others = world.host.overlay(world.host.index), [world.host.overlay(index) for index in indexes]
    assert [world.host.overlay(index) for index in (world.host.index, *indexes)] == [mine, *others]
    world.host.processes.append(SimpleNamespace(index=indexes[1]))
    world.host.forget_overlays()
    world.host.processes.clear()
    assert [overlay for _, overlay in world.host._overlays] == [mine, others[1]]
