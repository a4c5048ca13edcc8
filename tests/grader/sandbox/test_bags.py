"""What a bag holds is counted; files that are no bag, or a hostile one, come to nothing."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import pytest
from edugrade.sandbox import bags
from rosbags.rosbag2 import StoragePlugin, Writer

MESSAGE = bytes((0, 1, 0, 0)) + bytes(4)


def written(folder: Path, messages: list[tuple[int, bytes]], storage: str = 'MCAP') -> Path:
    with Writer(folder, version=9, storage_plugin=StoragePlugin[storage]) as writer:
        kind = 'std_msgs/msg/Int32'
        connection = writer.add_connection('/count', kind, msgdef='int32 data', rihs01='RIHS01_' + 64 * '0')
        for time_ns, data in messages:
            writer.write(connection, time_ns, data)
    return folder


def found(home: Path, *published: bytes) -> list[tuple[str, dict[str, list[int]]]]:
    return [(each['folder'], each['topics']) for each in bags.written_bags(str(home), 100, lambda topic: Counter(published))]


@pytest.mark.parametrize('storage', ['MCAP', 'SQLITE3'])
def test_each_published_message_counts_once_and_what_comes_after_the_end_not_at_all(tmp_path: Path, storage: str) -> None:
    other = MESSAGE[:-1] + b'\1'
    written(tmp_path / 'drive', [(1, MESSAGE), (2, MESSAGE), (3, other), (101, other)], storage)
    assert found(tmp_path, MESSAGE, other) == [('drive', {'/count': [3, 2]})]
    assert found(tmp_path) == [('drive', {'/count': [3, 0]})]


def test_bags_come_in_the_order_of_their_paths_and_only_a_few(tmp_path: Path) -> None:
    for name in 'fedcba':
        written(tmp_path / name, [(1, MESSAGE)])
    assert [folder for folder, _ in found(tmp_path)] == ['a', 'b', 'c', 'd']


def _fifo(bag: Path) -> None:
    (storage,) = bag.glob('*.mcap')
    storage.unlink()
    os.mkfifo(storage)


def _link(bag: Path) -> None:
    (storage,) = bag.glob('*.mcap')
    storage.unlink()
    storage.symlink_to('/dev/zero')


def _named(name: str) -> Callable[[Path], None]:
    def change(bag: Path) -> None:
        (storage,) = bag.glob('*.mcap')
        text = (bag / 'metadata.yaml').read_text()
        assert storage.name in text
        (bag / 'metadata.yaml').write_text(text.replace(storage.name, name))

    return change


def _cut(bag: Path) -> None:
    (storage,) = bag.glob('*.mcap')
    storage.write_bytes(storage.read_bytes()[:100])


def _large(bag: Path) -> None:
    with open(bag / 'more', 'wb') as file:
        file.truncate(bags.MOST_BYTES)


HOSTILE: dict[str, Callable[[Path], None]] = {
    'a pipe that nobody writes to': _fifo,
    'a link to a device': _link,
    'a file elsewhere': _named('/dev/zero'),
    'a file above': _named('../drive/drive.mcap'),
    'a cut file': _cut,
    'a large file': _large,
    'no YAML': lambda bag: (bag / 'metadata.yaml').write_bytes(b'\xff: ['),
    'objects of Python': lambda bag: (bag / 'metadata.yaml').write_text('!!python/object/apply:os._exit [7]'),
    'a list': lambda bag: (bag / 'metadata.yaml').write_text('[]'),
    'many files': lambda bag: [(bag / str(number)).touch() for number in range(bags.MOST_FILES)] and None,
}


@pytest.mark.parametrize('what', HOSTILE)
def test_what_is_no_bag_has_no_messages(tmp_path: Path, what: str) -> None:
    HOSTILE[what](written(tmp_path / 'drive', [(1, MESSAGE)]))
    assert found(tmp_path, MESSAGE) == [('drive', {})]


def test_more_messages_than_can_be_read_are_no_bag(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bags, 'MOST_MESSAGES', 2)
    written(tmp_path / 'drive', [(1, MESSAGE), (2, MESSAGE), (3, MESSAGE)])
    assert found(tmp_path, MESSAGE) == [('drive', {})]


def test_a_bag_may_hold_as_many_topics_as_the_limit_and_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bags, 'MOST_TOPICS', 2)
    named = [(name, 1, MESSAGE) for name in ('/a', '/b', '/c')]

    def counted(many: list[tuple[str, int, bytes]]) -> list[str]:
        return list(bags._counted(iter(many), 100, lambda topic: Counter()))

    assert counted([*named[:2], named[0]]) == ['/a', '/b']
    with pytest.raises(ValueError, match='too much'):
        counted([*named, named[0]])
