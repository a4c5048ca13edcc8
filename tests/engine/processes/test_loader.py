"""Private modules."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.processes.finding import read_script


def test_two_copies_of_a_program_do_not_share_globals(world: Any) -> None:
    world.write('lib/counter.py', 'count = 0\ndef up():\n    global count\n    count += 1\n    return count\n')
    script = world.write('p.py', 'import counter\nprint(counter.up(), counter.up())')
    world.start(script, 'a')
    world.start(script, 'b')
    world.sim.run()
    assert [text for *_, text in world.log] == ['1 2\n', '1 2\n']


def test_packages_submodules_and_relative_imports_work(world: Any) -> None:
    world.write('lib/robot/__init__.py', 'from . import parts\nfrom .parts import ARM\n')
    world.write('lib/robot/parts.py', 'ARM = "arm"\n')
    world.write('lib/robot/deep/__init__.py', '')
    world.write('lib/robot/deep/inner.py', 'from ..parts import ARM\nfrom .. import parts as p\nNAME = ARM + p.ARM\n')
    assert (
        world.run("""
        import robot, robot.deep.inner as inner
        from robot.deep import inner as again
        from robot import *
        print(robot.ARM, inner.NAME, again is inner, robot.parts.ARM)
        """)
        == 'arm armarm True arm\n'
    )


def test_a_module_that_its_package_imports_is_executed_once(world: Any) -> None:
    world.write('lib/robot/__init__.py', 'from .core.part import TOKEN\n')
    world.write('lib/robot/core/__init__.py', 'from .part import TOKEN\nfrom .other import SAME\n')
    world.write('lib/robot/core/part.py', 'print("once")\nTOKEN = object()\n')
    world.write('lib/robot/core/other.py', 'from .part import TOKEN\nSAME = TOKEN\n')
    assert (
        world.run("""
        import robot.core.part as part
        import robot.core.other as other
        import robot
        print(part.TOKEN is other.SAME is robot.core.TOKEN is robot.TOKEN)
        """)
        == 'once\nTrue\n'
    )


def test_the_scripts_folder_comes_first_on_its_path(world: Any) -> None:
    world.write('sibling.py', 'NAME = "beside the script"\n')
    world.write('lib/sibling.py', 'NAME = "in the workspace"\n')
    assert world.run('import sibling\nprint(sibling.NAME)') == 'beside the script\n'


def test_folders_put_on_sys_path_are_searched(world: Any) -> None:
    world.write('elsewhere/found.py', 'NAME = "found"\n')
    assert (
        world.run(f'import sys\nsys.path.insert(0, {str(world.folder / "elsewhere")!r})\nimport found\nprint(found.NAME)')
        == 'found\n'
    )


@pytest.mark.parametrize(
    ('text', 'error'),
    [
        ('import no_such_module', "ModuleNotFoundError: No module named 'no_such_module'"),
        ('import robot.no_such', "ModuleNotFoundError: No module named 'robot.no_such'"),
        ('from robot import no_such', "ImportError: cannot import name 'no_such' from 'robot'"),
        ('from .x import y', 'ImportError: attempted relative import with no known parent package'),
    ],
)
def test_import_errors_are_pythons(world: Any, text: str, error: str) -> None:
    world.write('lib/robot/__init__.py', '')
    assert error in [line for line in world.run(text).splitlines() if not line.startswith('  ')][-1]


def test_dataclasses_with_string_annotations_find_their_module(world: Any) -> None:
    world.write(
        'lib/shapes.py',
        """
        from __future__ import annotations
        from dataclasses import dataclass, field
        from typing import ClassVar
        @dataclass
        class Box:
            size: float = 1.0
            names: list[str] = field(default_factory=list)
            kind: ClassVar[str] = 'box'
        """,
    )
    assert world.run('from shapes import Box\nprint(Box(2.0), Box.kind)') == 'Box(size=2.0, names=[]) box\n'


def test_the_standard_library_is_shared_and_nothing_is_left_behind(world: Any) -> None:
    import sys

    before = set(sys.modules)
    world.write('lib/mine.py', 'import json\nTEXT = json.dumps([1])\n')
    assert world.run('import mine, json\nprint(mine.TEXT, mine.json is json)') == '[1] True\n'
    assert 'mine' not in set(sys.modules) - before


def test_a_module_that_fails_can_be_imported_again(world: Any) -> None:
    world.write(
        'lib/shaky.py', 'import time\nif time.time() < 1_700_000_001:\n    raise RuntimeError("too early")\nNAME = "now"\n'
    )
    assert (
        world.run("""
        import time
        try:
            import shaky
        except RuntimeError as error:
            print(error)
        time.sleep(2)
        import shaky
        print(shaky.NAME)
        """)
        == 'too early\nnow\n'
    )


def test_main_is_main_and_knows_its_file(world: Any) -> None:
    assert world.run("if __name__ == '__main__':\n    print(__file__.rsplit('/')[-1])") == 'program-1.py\n'


def test_folders_put_last_on_sys_path_do_not_hide_shared_modules(world: Any) -> None:
    world.write('elsewhere/json.py', 'NAME = "mine"\n')
    world.write('elsewhere/only_here.py', 'NAME = "found"\n')
    assert (
        world.run(
            f'import sys\nsys.path.append({str(world.folder / "elsewhere")!r})\nimport json, only_here\n'
            'print(hasattr(json, "dumps"), only_here.NAME)'
        )
        == 'True found\n'
    )


def test_folders_beside_the_package_do_not_hide_shared_modules(world: Any) -> None:
    """`launch/` and `test/` of a source package are no modules of it."""
    world.write('lib/launch/my.launch.py', '')
    world.write('lib/helpers/tool.py', 'NAME = "tool"\n')
    assert (
        world.run('import launch\nfrom helpers import tool\nprint(hasattr(launch, "LaunchDescription"), tool.NAME)')
        == 'True tool\n'
    )


def test_importlib_finds_private_modules(world: Any) -> None:
    world.write('lib/robot/__init__.py', '')
    world.write('lib/robot/arm.py', 'count = 0\n')
    assert (
        world.run("""
        import importlib, importlib.util, robot.arm
        again = importlib.import_module('robot.arm')
        relative = importlib.import_module('.arm', package='robot')
        again.count += 1
        importlib.reload(again)
        print(again is robot.arm is relative, again.count, __import__('robot').arm is again)
        print(importlib.util.find_spec('robot.arm').name, importlib.util.find_spec('robot.leg'))
        """)
        == 'True 0 True\nrobot.arm None\n'
    )


def test_a_module_made_from_a_spec_runs_in_the_simulation(world: Any) -> None:
    path = world.write('elsewhere/clock.py', 'import time\nNOW = time.time()\n')
    assert (
        world.run(f"""
        import importlib.util
        spec = importlib.util.spec_from_file_location('clock', {path!r})
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        print(module.NOW)
        """)
        == '1700000000.0\n'
    )


def test_data_of_a_package_is_found(world: Any) -> None:
    world.write('lib/robot/__init__.py', '')
    world.write('lib/robot/data/words.txt', 'hello\n')
    assert (
        world.run("""
        import os, robot
        from importlib import resources
        here = os.path.join(os.path.dirname(robot.__file__), 'data', 'words.txt')
        with open(here) as file:
            print(file.read(), end='')
        print(resources.files('robot').joinpath('data/words.txt').read_text(), end='')
        """)
        == 'hello\n' * 2
    )


def test_a_text_without_warnings_is_compiled_once_for_all_runs(tmp_path: Path) -> None:
    path = tmp_path / 'p.py'
    path.write_text('x = 1\n')
    first = read_script(str(path))
    path.write_text('x = 1\n')
    assert read_script(str(path)) is first
    path.write_text('x = 2\n')
    assert read_script(str(path)) is not first


@pytest.mark.parametrize(('text', 'kind'), [('x = 1 is 1\n', SyntaxWarning), ('x = "\\d"\n', Warning)])
def test_what_python_says_about_a_text_it_says_each_time(tmp_path: Path, text: str, kind: type[Warning]) -> None:
    path = tmp_path / 'p.py'
    path.write_text(text)
    for _ in range(2):
        with pytest.warns(kind):
            read_script(str(path))


def test_a_warning_that_was_ignored_comes_when_it_is_wanted(tmp_path: Path) -> None:
    path = tmp_path / 'p.py'
    path.write_text('x = 3 is 3\n')
    with warnings.catch_warnings():
        warnings.simplefilter('ignore')
        first = read_script(str(path))
        assert read_script(str(path)) is first
    with pytest.warns(SyntaxWarning):
        read_script(str(path))


def test_reading_a_script_forgets_no_warning_that_was_shown(tmp_path: Path) -> None:
    path = tmp_path / 'p.py'
    path.write_text('x = 4\n')
    with warnings.catch_warnings(record=True) as shown:
        warnings.simplefilter('default')
        registry: dict[Any, Any] = {}
        for _ in range(2):
            warnings.warn_explicit('again', UserWarning, 'file', 1, registry=registry)
            read_script(str(path))
    assert len(shown) == 1


def test_a_broken_text_is_an_error_each_time(tmp_path: Path) -> None:
    path = tmp_path / 'p.py'
    path.write_text('x = (\n')
    for _ in range(2):
        with pytest.raises(SyntaxError, match='was never closed'):
            read_script(str(path))


def test_a_star_takes_in_the_modules_that_are_promised(world: Any) -> None:
    world.write('lib/robot/__init__.py', '__all__ = ["arm", "SIZE"]\nSIZE = 3\n')
    world.write('lib/robot/arm.py', 'NAME = "arm"\n')
    assert world.run('from robot import *\nprint(arm.NAME, SIZE)') == 'arm 3\n'


def test_a_folder_of_folders_is_a_package_too(world: Any) -> None:
    world.write('fleet/left/arm.py', 'NAME = "left"\n')
    assert world.run('import fleet.left.arm as arm\nprint(arm.NAME)') == 'left\n'


@pytest.mark.parametrize('name', ['queue', 'random', 'logging', 'json'])
def test_a_file_beside_the_script_hides_the_standard_module_of_its_name(world: Any, name: str) -> None:
    path = world.write(f'{name}.py', 'MINE = True\n')
    text = world.run(f'import {name}\nprint({name}.MINE)\n{name}.nothing')
    assert text.startswith('True\n')
    assert text.splitlines()[-1] == f'  help: Python imports {path} instead of its own module {name}; rename {path}'


@pytest.mark.parametrize('name', ['time', 'sys', 'os'])
def test_what_python_has_loaded_itself_is_not_hidden(world: Any, name: str) -> None:
    world.write(f'{name}.py', 'MINE = True\n')
    assert world.run(f'import {name}\nprint(hasattr({name}, "MINE"))') == 'False\n'


def test_a_module_is_made_from_a_file_in_the_working_folder(world: Any) -> None:
    world.write('elsewhere/part.py', 'NAME = "part"\n')
    assert (
        world.run(f"""
        import importlib.util, os, sys
        os.chdir({str(world.folder / 'elsewhere')!r})
        spec = importlib.util.spec_from_file_location('made', 'part.py')
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        print(module.NAME, module.__file__ == os.path.abspath('part.py'))
        """)
        == 'part True\n'
    )


def test_a_module_made_by_the_type_of_sys_is_an_ordinary_one(world: Any) -> None:
    assert (
        world.run("""
        import sys
        sys.modules['made'] = type(sys)('made', 'of nothing')
        import made
        print(made.__name__, made.__doc__)
        """)
        == 'made of nothing\n'
    )


def test_the_source_of_the_program_s_own_classes_is_found(world: Any) -> None:
    world.write('lib/robot.py', 'class Arm:\n    def move(self): ...\n')
    assert (
        world.run("""
        import inspect
        import robot
        print(inspect.getsource(robot.Arm).splitlines()[1].strip(), inspect.getmodule(robot.Arm) is robot)
        """)
        == 'def move(self): ... True\n'
    )


def test_what_a_program_puts_into_builtins_is_its_own(world: Any) -> None:
    changing = world.write(
        'p.py',
        'import builtins\nbuiltins.SIZE = 3\nbuiltins.print = lambda text: sys.stdout.write(f"<{text}>")\n'
        'import sys\nprint(SIZE)',
    )
    other = world.write('q.py', 'print("SIZE" in dir(__builtins__) or "SIZE" in __builtins__)')
    world.start(changing, 'a')
    world.start(other, 'b')
    world.sim.run()
    assert [text for *_, text in world.log] == ['<3>', 'False\n']


def test_each_module_knows_the_package_it_is_in(world: Any) -> None:
    world.write('lib/robot/__init__.py', 'HERE = __package__\n')
    world.write('lib/robot/arm.py', 'HERE = __package__\n')
    world.write('lib/alone.py', 'HERE = __package__\n')
    assert (
        world.run("""
        import alone, robot, robot.arm
        print([alone.HERE, robot.HERE, robot.arm.HERE, __package__])
        """)
        == "['', 'robot', 'robot', None]\n"
    )


def test_a_module_that_is_run_is_in_its_package(world: Any) -> None:
    world.write('lib/robot/__init__.py', '')
    world.write('lib/robot/parts.py', 'ARM = "arm"\n')
    world.write('lib/robot/main.py', 'from .parts import ARM\nprint(__name__, __package__, ARM)\n')
    script = 'from edulaunch.engine.processes.current import current_process\n'
    assert world.run(script + 'current_process().loader.run_module("robot.main")') == '__main__ robot arm\n'


def test_a_launch_file_is_in_no_package(world: Any) -> None:
    world.write('my.launch.py', 'print([__name__, __package__, __spec__.origin == __file__])\n')
    script = 'from edulaunch.engine.processes.current import current_process\n'
    assert world.run(script + f'current_process().loader.run_file({str(world.folder / "my.launch.py")!r}, "my_launch")') == (
        "['my_launch', '', True]\n"
    )
