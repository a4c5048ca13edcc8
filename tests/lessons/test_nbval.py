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


def test_a_changed_pose_and_a_changed_digest_fail_and_nothing_else_does(tmp_path: Path) -> None:
    raw = Lesson('01_first_launch').raw
    raw['cells'] = [cell for cell in raw['cells'] if cell['id'] in KEPT]
    text = json.dumps(raw)
    graph = Lesson('01_first_launch')['square-graph'].outputs[0]['data'][SCENE_TYPE]['digest']
    for old, new in (('the turtle: (5.5', 'the turtle: (5.4'), (f'"digest": "{graph}"', '"digest": "00000000"')):
        assert text.count(old) == 1
        text = text.replace(old, new)
    (tmp_path / 'some.ipynb').write_text(text, encoding='utf-8')
    words = ['-p', 'no:cacheprovider', '-c', '/dev/null', '--nbval', '--nbval-current-env', '--nbval-cell-timeout=60', 'some.ipynb']
    done = subprocess.run([sys.executable, '-m', 'pytest', '-q', '-rf', *words], cwd=tmp_path, capture_output=True, text=True)
    assert re.findall(r'FAILED some\.ipynb::Cell (\d)', done.stdout) == ['2', '4'], done.stdout
