"""logging, pickle and modules that are imported inside."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.processes.spec import ProcessSpec


def test_logging_is_private_and_its_stamps_are_simulated(world: Any) -> None:
    import logging

    handlers = list(logging.getLogger().handlers)
    assert (
        world.run("""
        import logging, time
        logging.basicConfig(level=logging.INFO, format='%(asctime)s %(levelname)s %(name)s %(message)s')
        time.sleep(1.5)
        logging.getLogger('robot').info('moves')
        """)
        == '2023-11-14 22:13:21,500 INFO robot moves\n'
    )
    assert logging.getLogger().handlers == handlers


def test_objects_of_the_programs_own_classes_can_be_pickled(world: Any) -> None:
    world.write('lib/shapes.py', 'class Square:\n    side = 2')
    assert (
        world.run("""
        import pickle
        from dataclasses import dataclass
        import shapes
        @dataclass
        class Point:
            x: int
        print(pickle.loads(pickle.dumps([Point(3), {'a': 1.5}])), pickle.loads(pickle.dumps(shapes.Square())).side)
        """)
        == "[Point(x=3), {'a': 1.5}] 2\n"
    )


def test_dates_can_be_pickled(world: Any) -> None:
    assert (
        world.run('import pickle, datetime\nprint(pickle.loads(pickle.dumps([datetime.datetime.now(), datetime.date.today()])))')
        == '[datetime.datetime(2023, 11, 14, 22, 13, 20), datetime.date(2023, 11, 14)]\n'
    )


def test_data_without_a_named_package_is_that_of_the_package_that_asks(world: Any) -> None:
    world.write(
        'lib/robot/__init__.py', 'from importlib import resources\nTEXT = resources.files().joinpath("a.txt").read_text()\n'
    )
    world.write('lib/robot/a.txt', 'of the robot')
    assert world.run('import robot\nprint(robot.TEXT)') == 'of the robot\n'


def test_data_of_a_module_that_is_given_itself_is_found(world: Any) -> None:
    world.write('lib/robot/__init__.py', '')
    world.write('lib/robot/a.txt', 'of the robot')
    assert (
        world.run('import robot\nfrom importlib import resources\nprint(resources.files(robot).joinpath("a.txt").read_text())')
        == 'of the robot\n'
    )


@pytest.mark.parametrize(
    'name', ["'file.txt'", "b'file.txt'", "pathlib.Path('file.txt')", "os.open('{folder}/file.txt', os.O_RDONLY)"]
)
@pytest.mark.parametrize('has_folder', [True, False])
def test_a_file_is_opened_in_the_folder_of_the_program(
    world: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, has_folder: bool
) -> None:
    folder = tmp_path / 'here'
    folder.mkdir()
    (folder / 'file.txt').write_text('found')
    if not has_folder:
        monkeypatch.chdir(folder)
    script = world.write(
        'reads.py', f'import os, pathlib\nwith open({name.format(folder=folder)}) as file:\n    print(file.read())'
    )
    wrote: list[str] = []
    spec = ProcessSpec(argv=('python3', script), name='reads-1', cwd=str(folder) if has_folder else None)
    world.host.start(spec, lambda stream, text: wrote.append(text))
    world.sim.run()
    assert ''.join(wrote) == 'found\n'
