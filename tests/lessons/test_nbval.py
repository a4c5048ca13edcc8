"""Strict nbval notices a stored output that is not what the cell gives."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.canvas.picture import SCENE_TYPE
from tests.lessons.notebook import Lesson

pytest.importorskip('nbval', reason='nbval is not installed')
KEPT = ('set-up', 'square', 'square-run', 'square-picture', 'square-graph')
CONFTEST = 'from edulaunch.course.stored import pytest_itemcollected\n'
WORDS = ['-p', 'no:cacheprovider', '--nbval', '--nbval-current-env', '--nbval-cell-timeout=60', 'some.ipynb']


@pytest.mark.whole
def test_a_changed_pose_and_a_changed_digest_fail_and_nothing_else_does(tmp_path: Path) -> None:
    lesson = Lesson('01_first_launch')
    lesson.raw['cells'] = [cell for cell in lesson.raw['cells'] if cell['id'] in KEPT]
    (tmp_path / 'some.ipynb').write_text(json.dumps(lesson.raw), encoding='utf-8')
    text = json.dumps({name: lesson.kept[name] for name in KEPT})
    graph = lesson['square-graph'].outputs[0]['data'][SCENE_TYPE]['digest']
    for old, new in (('The result is (5.5', 'The result is (5.4'), (f'"digest": "{graph}"', '"digest": "00000000"')):
        assert text.count(old) == 1
        text = text.replace(old, new)
    (tmp_path / '.outputs').mkdir()
    (tmp_path / '.outputs' / 'some.json').write_text(text, encoding='utf-8')
    (tmp_path / 'conftest.py').write_text(CONFTEST)
    (tmp_path / 'pytest.ini').write_text('[pytest]\n')
    done = subprocess.run([sys.executable, '-m', 'pytest', '-q', '-rf', *WORDS], cwd=tmp_path, capture_output=True, text=True)
    assert re.findall(r'FAILED some\.ipynb::Cell (\d)', done.stdout) == ['2', '4'], done.stdout
