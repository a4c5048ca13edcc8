"""A private folder is removed, whatever is in it."""

from __future__ import annotations

import os
import socket
from pathlib import Path

from edugrade.sandbox.remove_tree import remove_tree


def test_odd_things_are_removed_and_links_are_not_followed(tmp_path: Path) -> None:
    outside = tmp_path / 'outside'
    outside.mkdir()
    (outside / 'kept').write_text('x')
    folder = tmp_path / 'folder'
    (folder / 'a' / 'b' / 'c').mkdir(parents=True)
    (folder / 'link').symlink_to(outside)
    (folder / 'a' / 'link').symlink_to(outside)
    os.mkfifo(folder / 'a' / 'pipe')
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(folder / 'a' / 's'))
    (folder / 'a' / 'b' / 'file').write_text('x')
    for path, mode in ((folder / 'a' / 'b' / 'c', 0o000), (folder / 'a' / 'b', 0o500), (folder / 'a', 0o000)):
        path.chmod(mode)
    remove_tree(str(folder))
    assert sorted(path.name for path in tmp_path.iterdir()) == ['outside']
    assert (outside / 'kept').read_text() == 'x'


def test_folders_deeper_than_any_path_are_removed(tmp_path: Path) -> None:
    folder = tmp_path / 'folder'
    folder.mkdir()
    before = os.getcwd()
    os.chdir(folder)
    try:
        for _ in range(1100):  # deeper than Python's stack, too
            os.mkdir('deep')
            os.chdir('deep')
    finally:
        os.chdir(before)
    remove_tree(str(folder))
    assert list(tmp_path.iterdir()) == []
