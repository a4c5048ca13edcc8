"""The edition for a browser: its files, and what its page calls. In a browser it is tried by tests/browser/test_lite.py."""

from __future__ import annotations

import json
from pathlib import Path
from zipfile import ZipFile

import pytest

from edulaunch.course.copying import new_course
from edulaunch.course.lite.in_browser import check, contents, launch
from edulaunch.course.lite.site import RUNTIME, make_site
from edulaunch.errors import UnusableInput

ROOT = Path(__file__).resolve().parents[2]
DEMO = 'turtle_tf2_demo.launch.py'


def runtime(folder: Path, abi: str = '2025_0') -> str:
    """Something with the names of Pyodide's files."""
    folder.mkdir()
    for name in RUNTIME:
        (folder / name).write_bytes(b'')
    lock = {'info': {'abi_version': abi}, 'packages': {'numpy': {'file_name': 'numpy.whl'}}}
    (folder / 'pyodide-lock.json').write_text(json.dumps(lock))
    return str(folder)


def test_the_site_has_all_that_the_page_asks_for(tmp_path: Path) -> None:
    out = tmp_path / 'site'
    (note,) = make_site(str(out), runtime(tmp_path / 'pyodide'), str(ROOT))
    assert 'numpy' in note and json.loads((out / 'site.json').read_text()) == {'packages': []}
    script = (out / 'worker.mjs').read_text() + (out / 'desk.mjs').read_text() + (out / 'index.html').read_text()
    for name in ('site.json', 'edulaunch.zip', 'course.zip', 'worker.mjs', 'desk.mjs', 'style.css', 'pyodide/pyodide.mjs'):
        assert name in script and (out / name).is_file()
    assert '//' not in script.replace('// ', '')  # no address of another machine
    engine = ZipFile(out / 'edulaunch.zip').namelist()
    for name in ('greenlet.py', 'edulaunch/runtime/session.py', 'edugrade/checks/circle.py', 'yaml/__init__.py'):
        assert name in engine
    assert not [name for name in engine if name.endswith(('.so', '.pyc'))]
    course = ZipFile(out / 'course.zip').namelist()
    assert 'exercises/course.toml' in course and not [name for name in course if 'solution' in name or 'lessons' in name]


def test_a_course_of_ones_own_brings_its_rubrics_and_numpy_comes_along(tmp_path: Path) -> None:
    new_course(str(tmp_path / 'mine'))
    folder = runtime(tmp_path / 'pyodide')
    (tmp_path / 'pyodide' / 'numpy.whl').write_bytes(b'')
    assert make_site(str(tmp_path / 'site'), folder, str(tmp_path / 'mine')) == []
    assert (tmp_path / 'site' / 'pyodide' / 'numpy.whl').is_file()
    assert ZipFile(tmp_path / 'site' / 'course.zip').namelist() == [
        'course.toml',
        'exercises/spin.launch.py',
        'rubrics/spin.yaml',
    ]


def test_other_folders_are_refused(tmp_path: Path) -> None:
    with pytest.raises(UnusableInput, match='it lacks pyodide.mjs'):
        make_site(str(tmp_path / 'site'), str(tmp_path), str(ROOT))
    with pytest.raises(UnusableInput, match='crash when tasks switch'):
        make_site(str(tmp_path / 'site'), runtime(tmp_path / 'newer', '2026_0'), str(ROOT))
    with pytest.raises(UnusableInput, match='is not empty'):
        make_site(str(tmp_path), runtime(tmp_path / 'pyodide'), str(ROOT))


@pytest.mark.processes
def test_a_file_is_chosen_launched_and_checked(tmp_path: Path) -> None:
    files = json.loads(contents(str(ROOT)))
    assert [item['exercise'] for item in files][:2] == ['circle', 'two_rooms']
    assert 'large_project' not in [item['exercise'] for item in files]  # a package
    demo = next(item for item in files if item['name'] == DEMO)
    said: list[str] = []
    answer = json.loads(launch(str(tmp_path / 'exercises' / DEMO), demo['text'], 'target_frame:=turtle1', 4.0, said.append))
    assert answer['page'].startswith('<!DOCTYPE html>') and 'Spawning turtle [turtle2]' in ''.join(said)
    solved = (ROOT / 'solutions' / 'water.launch.py').read_text(encoding='utf-8')
    answer = json.loads(check(str(tmp_path / 'water.launch.py'), solved))
    assert answer['said'] == 'water: all passed\n' and 'checks passed' in answer['page']


def test_what_is_wrong_is_said(tmp_path: Path) -> None:
    path = str(tmp_path / 'x.launch.py')
    assert 'help: write name:=value' in json.loads(launch(path, '', 'radius=3', 1.0, print))['error']
    assert "No module named 'nothing_such'" in json.loads(launch(path, 'import nothing_such', '', 1.0, print))['error']
    assert 'no rubric' in json.loads(check(path, ''))['error'].lower()
