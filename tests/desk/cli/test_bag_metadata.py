"""Whatever stands in the metadata or the file of a bag: an answer or a sentence, never a traceback."""

from __future__ import annotations

import copy
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from edulaunch.desk.cli.ros2.bag_metadata import ROOT, read_metadata

Machine = Any
FEW = settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5) | st.dates(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=5,
)
GOOD: dict[str, Any] = {
    'version': 9,
    'storage_identifier': 'mcap',
    'relative_file_paths': ['x.mcap'],
    'message_count': 1,
    'starting_time': {'nanoseconds_since_epoch': 5},
    'duration': {'nanoseconds': 7},
    'topics_with_message_count': [
        {'message_count': 1, 'topic_metadata': {'name': '/a', 'type': 'std_msgs/msg/String', 'serialization_format': 'cdr'}}
    ],
}


def places(value: Any, way: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Where anything stands."""
    if way:
        yield way
    for key in value if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else ():
        yield from places(value[key], (*way, key))


PLACES = list(places(GOOD))


def bag_with(folder: Path, content: str) -> Callable[[], dict[str, Any]]:
    (folder / 'x.mcap').touch()
    (folder / 'metadata.yaml').write_text(content, encoding='utf-8', errors='surrogatepass')
    return lambda: read_metadata('bag', str(folder))


def test_good_metadata_are_read(tmp_path: Path) -> None:
    assert bag_with(tmp_path, yaml.safe_dump({ROOT: GOOD}))() == GOOD


@pytest.mark.parametrize(
    ('change', 'expected'),
    [
        (lambda good: good.pop('duration'), 'metadata.yaml: duration.nanoseconds is not a whole number'),
        (lambda good: good.update(message_count=-1), 'metadata.yaml: message_count is not a whole number'),
        (
            lambda good: good.update(relative_file_paths=['../x']),
            'relative_file_paths is not a list of files in the folder of the bag',
        ),
        (lambda good: good.update(relative_file_paths=['y']), "metadata.yaml: its file 'y' is missing"),
        (
            lambda good: good['topics_with_message_count'][0].update(topic_metadata=3),
            'metadata.yaml: topic 1: topic_metadata.name is not a text',
        ),
    ],
)
def test_the_error_names_the_entry(change: Callable[[Any], object], expected: str, tmp_path: Path) -> None:
    wrong = copy.deepcopy(GOOD)
    change(wrong)
    with pytest.raises(RuntimeError) as caught:
        bag_with(tmp_path, yaml.safe_dump({ROOT: wrong}))()
    text = str(caught.value)
    assert expected in text and text.startswith("[ERROR] [ros2bag]: 'bag' cannot be read: ") and 'help: give a bag' in text


@FEW
@given(place=st.sampled_from(PLACES), value=PLAIN)
def test_any_value_at_any_place(place: tuple[Any, ...], value: Any, tmp_path: Path) -> None:
    content = copy.deepcopy(GOOD)
    inner: Any = content
    for key in place[:-1]:
        inner = inner[key]
    inner[place[-1]] = value
    try:
        bag_with(tmp_path, yaml.safe_dump({ROOT: content}))()
    except RuntimeError as error:
        assert str(error).startswith("[ERROR] [ros2bag]: 'bag' cannot be read: ")


@FEW
@given(
    text=st.text(max_size=40) | st.sampled_from(['[' * 5000, '&a [*a]', '{a: *b}', '!!python/object:os.system {}', '2020-99-99'])
)
def test_any_text(text: str, tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match='cannot be read'):
        bag_with(tmp_path, text)()


@pytest.mark.parametrize('storage', ['mcap', 'sqlite3'])
def test_a_storage_file_that_is_cut_or_changed(machine: Machine, storage: str) -> None:
    machine.run(f'ros2 bag record -a -o good -s {storage}', 0.5).interrupt()
    [name] = [path.name for path in (machine.folder / 'good').iterdir() if path.name != 'metadata.yaml']
    data = (machine.folder / 'good' / name).read_bytes()
    half = len(data) // 2
    for number, wrong in enumerate(
        (b'', b'x', data[:half], data[: -len(data) // 4], data[:half] + b'\xff' * 40 + data[half + 40 :])
    ):
        bag = machine.folder / f'bag{number}'
        shutil.copytree(machine.folder / 'good', bag)
        (bag / name).write_bytes(wrong)
        played = machine.run(f'ros2 bag play {bag.name}', 3.0)
        assert 'Traceback' not in played.err
        assert played.code == 0 or f"[ERROR] [ros2bag]: '{bag.name}' cannot be read: " in played.err, played.err
