"""Parameter files that launch makes: what simulated programs read in them, and when they are on the disk."""

from __future__ import annotations

import gc
import glob
import math
import os
import tempfile
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from launch import LaunchContext
from launch_ros._generated_file import GeneratedFile, GeneratedParameters, temporary_path
from launch_ros.actions import Node
from launch_ros.descriptions import ParameterFile

from edulaunch import Session
from edulaunch.engine.graph.parameter_files import read_parameter_file

scalars = st.one_of(
    st.booleans(),
    st.integers(-(2**64), 2**64),
    st.floats(),
    st.text(max_size=6),
    st.sampled_from(['nan', '.inf', 'Inf', '0x10', '1e3', 'y', 'no', 'null', '~', 'a b', '/a/b', '1_0', 'a: b', '-', '']),
)
lists = st.one_of(
    st.lists(st.integers(), min_size=1), st.lists(st.floats(), min_size=1), st.lists(st.text(max_size=4), min_size=1)
)


@given(st.dictionaries(st.sampled_from(['a', 'b.c', 'no', '1', 'é']), st.one_of(scalars, lists.map(tuple)), min_size=1))
def test_what_programs_get_is_what_they_would_read_in_the_text(values: dict[str, Any]) -> None:
    file = GeneratedParameters('f', '/s/n', values)
    results = []
    for read in (file.entries, lambda: read_parameter_file(file.text)):
        try:
            results.append(repr(read()))
        except ValueError as error:
            results.append(repr(error))
    assert results[0] == results[1]


def test_plain_values_are_not_read_at_all(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(GeneratedParameters, 'text')
    entries = GeneratedParameters('f', '/**', {'b': (1, 2), 'a': 1.5, 'c': 'word'}).entries()
    assert [tuple(entry) for entry in entries] == [('/**', 'a', 1.5, 3), ('/**', 'b', [1, 2], 5), ('/**', 'c', 'word', 7)]
    assert math.isfinite(entries[0].value)


def test_a_file_is_on_the_disk_from_the_first_look_until_it_is_forgotten(tmp_path: Path) -> None:
    path = tmp_path / 'file'
    file = GeneratedFile(str(path), 'text')
    assert not path.exists()
    file.write()
    assert path.read_text() == 'text'
    del file
    gc.collect()
    assert not path.exists()


def test_the_file_of_another_run_stays(tmp_path: Path) -> None:
    path = tmp_path / 'file'
    mine, others = GeneratedFile(str(path), 'text'), GeneratedFile(str(path), 'text')
    mine.write()
    others.write()
    mine.remove()
    assert path.read_text() == 'text'
    others.remove()
    assert not path.exists()


def test_paths_repeat_from_run_to_run_and_differ_within_one() -> None:
    first, second = {}, {}  # type: ignore[var-annotated]
    assert temporary_path('a', first) == temporary_path('a', second) == temporary_path('a', first)
    assert temporary_path('b', first) != temporary_path('a', first)


def left() -> list[str]:
    return sorted(glob.glob(os.path.join(tempfile.gettempdir(), 'launch_params_*')))


@pytest.fixture
def temporary_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(tempfile, 'tempdir', str(tmp_path))
    return tmp_path


LAUNCH_FILE = """
from launch import LaunchDescription
from launch.actions import Shutdown
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', parameters=[{'background_r': 7}]),
        Node(executable='sh', arguments=['-c', 'cat "$7"', 'name'], name='n', namespace='s', parameters=[{'p': 1}], output='screen',
             on_exit=[Shutdown()]),
    ])
"""


def test_only_a_real_program_finds_its_file_on_the_disk_and_nothing_is_left(temporary_folder: Path) -> None:
    path = temporary_folder / 'a.launch.py'
    path.write_text(LAUNCH_FILE)
    said: list[str] = []
    with Session(env={'PATH': os.environ['PATH']}, console=lambda stream, text: said.append(text)) as session:
        session.launch(path)
        session.run(2.0)
        (file,) = left()
        assert Path(file).read_text() == '/s/n:\n  ros__parameters:\n    p: 1\n'
    assert '[sh-2]     p: 1\n' in ''.join(said)
    assert left() == []


def test_a_look_at_the_command_line_puts_the_file_there(temporary_folder: Path) -> None:
    context = LaunchContext()
    node = Node(package='p', executable='e', name='n', namespace='s', parameters=[{'p': 1}])
    node._perform_substitutions(context)
    ((path, is_file),) = node._Node__expanded_parameter_arguments  # type: ignore[attr-defined]
    assert (is_file, Path(path).read_text()) == (True, '/s/n:\n  ros__parameters:\n    p: 1\n')


def test_a_substituted_file_is_there_until_it_is_cleaned_up(temporary_folder: Path) -> None:
    source = temporary_folder / 'a.yaml'
    source.write_text('/**: {ros__parameters: {p: $(env NOT_SET 7)}}')
    plain, described = ParameterFile(source), ParameterFile(source, allow_substs=True)
    path = described.evaluate(LaunchContext())
    assert (path.read_text(), described.param_file) == ('/**: {ros__parameters: {p: 7}}', path)
    described.cleanup()
    assert (path.exists(), type(described.param_file)) == (False, list)
    assert plain.evaluate(LaunchContext()) == source
    plain.cleanup()
    assert (source.exists(), plain.param_file) == (True, source)


@pytest.mark.parametrize(
    'word', ['nan', 'NaN', 'inf', 'Infinity', 'yes', 'On', 'n', 'null', 'e1', 'x10', 'a_b', 'word', '_1', '/a']
)
def test_a_word_is_taken_as_it_is_only_when_its_text_would_give_it_back(word: str) -> None:
    file = GeneratedParameters('f', '/**', {'a': word})
    assert repr(file.entries()) == repr(read_parameter_file(file.text))
