"""Equal runs give equal pictures, byte for byte, whatever the hash seed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

PROGRAM = """
import hashlib, sys
from edulaunch import Recording
recording = Recording.load(sys.argv[1])
made = [recording.plot_turtles(), recording.plot_frames(), recording.plot_tf_tree(), recording.plot_graph(unused=True, services=True),
        recording.plot_distance('turtle2', 'turtle1'), recording.replay()]
for picture in made[:-1]:
    print(hashlib.sha256(picture.png()).hexdigest(), repr(picture))
print(hashlib.sha256(made[-1].html().encode()).hexdigest(), recording.parameter_table())
"""


@pytest.mark.processes
def test_two_processes_draw_the_same_bytes(
    demo: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    demo.save(tmp_path / 'demo.rec')
    other = subprocess.run(
        [sys.executable, '-c', PROGRAM, str(tmp_path / 'demo.rec')],
        cwd=Path(__file__).parents[2],
        check=True,
        capture_output=True,
        text=True,
        env={**os.environ, 'PYTHONHASHSEED': '1' if os.environ.get('PYTHONHASHSEED') != '1' else '2'},
    ).stdout
    monkeypatch.setattr(sys, 'argv', ['here', str(tmp_path / 'demo.rec')])
    exec(PROGRAM, {})
    assert capsys.readouterr().out == other and len(other.splitlines()) > 12
