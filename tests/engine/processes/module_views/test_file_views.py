"""Files and paths inside: the folder is that of the program."""

from __future__ import annotations

import os
from typing import Any

import pytest


@pytest.mark.parametrize(
    'ask',
    [
        'os.path.exists("words.txt")',
        'os.listdir() == ["words.txt"]',
        'os.path.abspath("x") == os.getcwd() + "/x"',
        'list(os.walk("."))[0] == (".", [], ["words.txt"])',
        '[e.path for e in os.scandir(".")] == ["./words.txt"]',
        '[Path(e).read_text() for e in os.scandir() if e.is_file()] == ["hello"]',
        'os.path.relpath(os.getcwd() + "/a/b") == "a/b"',
        'glob.glob("*.txt") == ["words.txt"]',
        'join("a", "b") == "a/b"',
        'os.stat("words.txt").st_size == 5',
        'Path("words.txt").read_text() == "hello"',
        'Path.cwd() == Path(os.getcwd())',
        'Path("words.txt").exists()',
        '[*Path().glob("*.txt")] == [Path("words.txt")]',
        'str(Path("x").resolve()) == os.getcwd() + "/x"',
        'io.open("words.txt").close() is None',
        'Path("words.txt").open().close() is None',
    ],
)
def test_relative_paths_are_looked_for_in_the_programs_own_folder(world: Any, ask: str) -> None:
    world.write('data/words.txt', 'hello')
    world.start(
        world.write(
            'p.py', f'import glob, io, os\nfrom os.path import join\nfrom pathlib import Path\nos.chdir("data")\nprint({ask})'
        ),
        cwd=str(world.folder),
    )
    world.sim.run()
    assert world.log[-1][2] == 'True\n'


def test_files_are_made_and_removed_in_the_programs_own_folder(world: Any) -> None:
    world.start(
        world.write(
            'p.py',
            """
        import os, shutil
        os.makedirs('a/b')
        open('a/b/file', 'w').close()
        os.rename('a/b/file', 'a/moved')
        shutil.rmtree('a/b')
        """,
        ),
        cwd=str(world.folder),
    )
    world.sim.run()
    assert world.codes == {'program-1': 0} and [path.name for path in (world.folder / 'a').iterdir()] == ['moved']


@pytest.mark.parametrize(
    'ask',
    [
        'os.listdir()',
        'os.listdir(".")',
        '[e.name for e in os.scandir(os.getcwd())]',
        '[p.name for p in Path().iterdir()]',
        'glob.glob("*")',
        '[f for _, folders, files in os.walk(os.getcwd()) for f in folders + files]',
    ],
)
@pytest.mark.parametrize('moved', ['', 'os.chdir("data")'])
def test_a_folder_is_listed_in_the_order_of_names(world: Any, monkeypatch: pytest.MonkeyPatch, ask: str, moved: str) -> None:
    """Two computers give two orders; here one is made that is surely not that of the names."""
    scan, names = os.scandir, os.listdir
    for name in ('b', 'c', 'a'):
        world.write(f'data/{name}', '')
    monkeypatch.setattr(os, 'scandir', lambda *path: Shuffled(sorted(scan(*path), key=lambda entry: entry.name, reverse=True)))
    monkeypatch.setattr(os, 'listdir', lambda *path: sorted(names(*path), reverse=True))
    program = world.write('p.py', f'import glob, os\nfrom pathlib import Path\n{moved}\nprint({ask})')
    world.start(program, cwd=str(world.folder / ('' if moved else 'data')))
    world.sim.run()
    assert world.log[-1][2] == "['a', 'b', 'c']\n"


def test_a_walk_from_the_bottom_comes_to_a_folder_after_what_it_holds(world: Any) -> None:
    for name in ('data/y/z/1', 'data/x/2'):
        world.write(name, '')
    world.start(world.write('p.py', 'import os\nprint([f for f, *_ in os.walk("data", topdown=False)])'), cwd=str(world.folder))
    world.sim.run()
    assert world.log[-1][2] == "['data/y/z', 'data/y', 'data/x', 'data']\n"


class Shuffled:
    """A listing in another order, as `os.scandir` gives one."""

    def __init__(self, entries: list[Any]) -> None:
        self._entries = iter(entries)

    def __iter__(self) -> Shuffled:
        return self

    def __next__(self) -> Any:
        return next(self._entries)

    def __enter__(self) -> Shuffled:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Nothing is open."""
