"""The reader of notebooks: what is right is read, and whatever else becomes one sentence."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.course.copying import student_files
from edulaunch.course.lesson_form import lesson_problems
from edulaunch.course.lessons import read_lessons
from edulaunch.course.notebook_file import Cell, parse_notebook, read_notebook, read_outputs_file
from edulaunch.course.stored import read_outputs, store_outputs, strip
from edulaunch.errors import UnusableInput


def written(cells: object, **more: object) -> bytes:
    return json.dumps({'cells': cells, 'metadata': {}, 'nbformat': 4, 'nbformat_minor': 5, **more}).encode()


def code(**more: object) -> dict[str, object]:
    return {'cell_type': 'code', 'id': 'one', 'source': 'print(1)', 'metadata': {}, 'outputs': [], **more}


def refusal(data: bytes) -> str:
    with pytest.raises(UnusableInput) as caught:
        parse_notebook(data, 'one.ipynb')
    assert caught.value.help == 'open it in JupyterLab and save it again'
    return str(caught.value).split('\n')[0].removeprefix('one.ipynb is not a notebook: ')


def test_a_source_is_one_string_whether_it_is_stored_as_one_or_as_lines() -> None:
    printed = {'output_type': 'stream', 'name': 'stdout', 'text': ['1\n']}
    cells = [{'cell_type': 'markdown', 'source': ['# Title\n', 'Text.']}, code(outputs=[printed], execution_count=3)]
    assert parse_notebook(written(cells), 'one.ipynb').cells == (
        Cell('', 'markdown', '# Title\nText.'),
        Cell('one', 'code', 'print(1)', (printed,), True),
    )


DAMAGED: dict[bytes, str] = {
    b'': 'it is not JSON (Expecting value: line 1 column 1 (char 0))',
    b'\xff\xfe': 'it is not text in UTF-8',
    b'[' * 100_000: 'its lists are nested too deeply',
    b'[]': 'it is JSON, but not an object',
    b'{}': 'it has no list "cells"',
    b'{"cells": {}}': 'it has no list "cells"',
    b'{"cells": [], "metadata": 1}': 'its "metadata" is not an object',
    written([1]): 'cell 1 is not an object',
    written([code(), code(cell_type='sql')]): 'cell 2 has a "cell_type" that is not one of code, markdown, raw',
    written([code(cell_type=['code'])]): 'cell 1 has a "cell_type" that is not one of code, markdown, raw',
    written([code(id=1)]): 'cell 1 has an "id" that is not a string',
    written([code(source=None)]): 'cell 1 has a "source" that is not a string or a list of strings',
    written([code(source=[1])]): 'cell 1 has a "source" that is not a string or a list of strings',
    written([code(metadata=[])]): 'cell 1 has "metadata" that is not an object with a list of tags',
    written([code(metadata={'tags': 'x'})]): 'cell 1 has "metadata" that is not an object with a list of tags',
    written([code(outputs={'a': 1})]): 'cell 1 has "outputs" that are not a list',
    written([code(outputs=[1])]): 'cell 1 has an output of an unknown kind',
    written([code(outputs=[{'output_type': 'stream'}])]): 'cell 1 has an output without "text"',
    written(
        [code(outputs=[{'output_type': 'display_data', 'data': 1}])]
    ): 'cell 1 has an output with "data" that is not an object',
    written([code(outputs=[{'output_type': 'display_data', 'data': {'image/png': 'a'}}])]): (
        'cell 1 has a picture that is not base64'
    ),
    written([code(outputs=[{'output_type': 'error', 'ename': 'E', 'evalue': '', 'traceback': 1}])]): (
        'cell 1 has an output with a "traceback" that is not a list of strings'
    ),
}


@pytest.mark.parametrize('data', DAMAGED, ids=lambda data: DAMAGED[data])
def test_what_is_wrong_is_named_with_its_cell_and_key(data: bytes) -> None:
    assert refusal(data) == DAMAGED[data]


def test_a_file_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    with pytest.raises(UnusableInput, match=r'the notebook .*gone\.ipynb cannot be read: No such file or directory'):
        read_notebook(str(tmp_path / 'gone.ipynb'))


ATOMS = (
    st.none()
    | st.booleans()
    | st.integers(-3, 3)
    | st.sampled_from(['', 'code', 'markdown', 'stream', 'display_data', 'error', 'a\nb'])
)
KEYS = [
    'cells',
    'cell_type',
    'id',
    'source',
    'metadata',
    'tags',
    'outputs',
    'output_type',
    'text',
    'data',
    'image/png',
    'text/plain',
]
ANYTHING = st.recursive(
    ATOMS, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(KEYS), inner, max_size=4)
)


@st.composite
def nearly_notebooks(draw: st.DrawFn) -> bytes:
    """A lesson in which up to three values, anywhere in it, are replaced by something else."""
    stream: dict[str, Any] = {'output_type': 'stream', 'name': 'stdout', 'text': ['1\n']}
    shown: dict[str, Any] = {'output_type': 'display_data', 'data': {'text/plain': 'x', 'image/png': ''}, 'metadata': {}}
    failed: dict[str, Any] = {'output_type': 'error', 'ename': 'E', 'evalue': 'v', 'traceback': ['t']}
    cells = [
        code(cell_type='markdown', source=['# T\n']),
        code(outputs=[stream, shown, failed], id='two', metadata={'tags': ['a']}),
    ]
    content: Any = {'cells': cells, 'metadata': {'kernelspec': {'name': 'python3'}}, 'nbformat': 4, 'nbformat_minor': 5}
    for _ in range(draw(st.integers(0, 3))):
        place, key = draw(st.sampled_from(_places(content)))
        place[key] = draw(ANYTHING)
    return json.dumps(content).encode()[: draw(st.sampled_from([None, None, None, 40, 200]))]


def _places(value: Any) -> list[tuple[Any, Any]]:
    inside = list(value) if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else []
    return [place for key in inside for place in ((value, key), *_places(value[key]))] or [({}, '')]


@given(data=nearly_notebooks())
def test_no_notebook_ends_a_course_tool_in_a_traceback(data: bytes, tmp_path_factory: pytest.TempPathFactory) -> None:
    course = tmp_path_factory.mktemp('course')
    lesson = course / 'lessons' / '01_one.ipynb'
    (lesson.parent / '.outputs').mkdir(parents=True)
    lesson.write_bytes(data)
    (lesson.parent / '.outputs' / '01_one.json').write_bytes(data)
    assert [one.name for one in read_lessons(str(lesson.parent))] == ['01_one']
    assert all(isinstance(problem, str) for problem in lesson_problems(str(course)))
    for tool in (lambda: student_files(str(course)), lambda: read_outputs(str(lesson)), lambda: strip(str(lesson))):
        try:
            tool()
        except UnusableInput as error:
            assert 'lessons' in str(error)


def test_outputs_are_stored_only_of_cells_with_an_id(tmp_path: Path) -> None:
    path = tmp_path / 'old.ipynb'
    path.write_bytes(written([{'cell_type': 'code', 'source': 'print(1)', 'metadata': {}, 'outputs': []}], nbformat_minor=4))
    with pytest.raises(UnusableInput, match='has a cell without an id'):
        store_outputs(str(path))


@pytest.mark.parametrize('content', ['[]', '{"a": 1}', '{"a": [1]}', '{"a": [{"output_type": "stream"}]}', '[' * 100_000, '{'])
def test_a_damaged_file_of_outputs_is_a_value_error(tmp_path: Path, content: str) -> None:
    path = tmp_path / 'one.json'
    path.write_text(content)
    with pytest.raises(ValueError):
        read_outputs_file(str(path))
