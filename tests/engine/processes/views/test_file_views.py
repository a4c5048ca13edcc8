"""Files and paths inside: the folder is that of the program."""

from __future__ import annotations

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
