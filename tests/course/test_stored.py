"""Outputs are kept beside a lesson, and the lesson has none."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from edulaunch.course.stored import outputs_file, read_outputs, without_place
from edulaunch.desk.cli.main import main
from edulaunch.errors import UnusableInput

pytest.importorskip('nbclient', reason='nbclient is not installed')
HTML = "from IPython.display import HTML, display\ndisplay(HTML('<b>long</b>'))"


def notebook(path: Path, *sources: str, tags: tuple[str, ...] = ()) -> Path:
    cells = [
        {
            'cell_type': 'code',
            'id': f'cell-{n}',
            'metadata': {'collapsed': True, 'tags': [*tags]},
            'source': source,
            'outputs': [],
            'execution_count': 7,
        }
        for n, source in enumerate(sources)
    ]
    meta = {
        'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'},
        'language_info': {'name': 'python', 'version': '3'},
    }
    path.write_text(json.dumps({'cells': cells, 'metadata': meta, 'nbformat': 4, 'nbformat_minor': 5}))
    return path


@pytest.mark.processes
def test_a_clean_run_is_kept_without_paths_and_pictures(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = notebook(tmp_path / 'one.ipynb', "print('seen')", 'x = 1', "import os; print(os.path.abspath('a.py'))", HTML)
    assert main(['course', 'store', str(path)]) == 0
    assert 'stored the outputs' in capsys.readouterr().out
    kept = read_outputs(str(path))
    assert list(kept) == ['cell-0', 'cell-1', 'cell-2', 'cell-3']
    assert [output['text'] for output in kept['cell-0'] + kept['cell-2']] == ['seen\n', 'a.py\n'] and kept['cell-1'] == []
    assert kept['cell-3'][0]['data'] == {'text/html': '', 'text/plain': '<IPython.core.display.HTML object>'}
    cell = json.loads(path.read_text())['cells'][0]
    assert (cell['outputs'], cell['execution_count'], cell['metadata']) == ([], None, {'tags': []})


@pytest.mark.processes
def test_a_cell_that_fails_is_told_and_nothing_is_kept(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = notebook(tmp_path / 'one.ipynb', '1 / 0')
    assert main(['course', 'store', str(path)]) == 2
    assert 'ZeroDivisionError' in capsys.readouterr().err
    assert not Path(outputs_file(str(path))).exists()


def test_a_lesson_without_kept_outputs_says_how_to_make_them(tmp_path: Path) -> None:
    with pytest.raises(UnusableInput, match='edulaunch course store one.ipynb'):
        read_outputs(str(tmp_path / 'one.ipynb'))


def test_the_place_of_a_run_is_no_difference() -> None:
    given = [{'text': '/home/me/course/my_launch/a.launch.py:3 (line 4 of cell [12]), and /home/you/x\n'}]
    assert without_place(given, '/home/me/course') == [{'text': 'my_launch/a.launch.py:3, and /home/you/x\n'}]


def test_a_lesson_that_is_not_there_is_told_with_the_nearest(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / '16_silent_systems.ipynb').write_text('{}')
    assert main(['course', 'store', str(tmp_path / '16_silent_system.ipynb')]) == 2
    near = tmp_path / '16_silent_systems.ipynb'
    assert capsys.readouterr().err.endswith(f"16_silent_system.ipynb does not exist\n  help: did you mean '{near}'?\n")


@pytest.mark.processes
def test_a_cell_that_fails_is_named_without_frames_and_colours(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = notebook(tmp_path / 'one.ipynb', 'x = 1', 'def inner():\n    return missing\n\n\ninner()')
    assert main(['course', 'store', str(path)]) == 2
    assert capsys.readouterr().err == (
        f"error: {path}: the cell cell-1 failed: NameError: name 'missing' is not defined\n"
        '  help: if the cell should fail, give it the tag raises-exception\n'
    )


def test_what_is_no_notebook_is_said_in_a_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'one.ipynb').write_text('3')
    assert main(['course', 'store', str(tmp_path / 'one.ipynb')]) == 2
    assert 'one.ipynb is not a notebook: it is JSON, but not an object' in capsys.readouterr().err
