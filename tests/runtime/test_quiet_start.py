"""Ctrl-C while a command starts, and while it runs: no traceback."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.runtime.quiet_start import INTERRUPTED, run_quietly

pytestmark = [pytest.mark.processes, pytest.mark.skipif(os.name == 'nt', reason='no such signals there')]
START = "import sys; from edulaunch.runtime.quiet_start import run_quietly; sys.exit(run_quietly('slow', 'main'))"
WAITS = "print('now', flush=True); time.sleep(600)"


@pytest.mark.parametrize(
    ('text', 'code'),
    [(f'import time\n{WAITS}\ndef main(): pass\n', -signal.SIGINT), (f'import time\ndef main():\n    {WAITS}\n', INTERRUPTED)],
)
def test_ctrl_c_is_silent(tmp_path: Path, text: str, code: int) -> None:
    (tmp_path / 'slow.py').write_text(text)
    env = {**os.environ, 'PYTHONPATH': os.pathsep.join([str(tmp_path), os.getcwd()])}
    with subprocess.Popen(
        [sys.executable, '-c', START], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=env
    ) as child:
        assert child.stdout is not None and child.stdout.readline() == 'now\n'
        child.send_signal(signal.SIGINT)
        assert child.communicate() == ('', '') and child.returncode == code


def test_the_code_of_a_command_is_kept(tmp_path: Path) -> None:
    done = subprocess.run([sys.executable, '-m', 'edulaunch', 'lanch'], capture_output=True, text=True)
    assert done.returncode == 2 and "did you mean 'launch'" in done.stderr


def test_a_computer_without_memory_for_a_module_is_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    before = signal.getsignal(signal.SIGINT)
    monkeypatch.syspath_prepend(tmp_path)
    (tmp_path / 'without_memory.py').write_text("raise ImportError('math.so: failed to map segment from shared object')")
    (tmp_path / 'damaged.py').write_text("raise ImportError('no such name')")
    assert run_quietly('without_memory', 'main', broken=3) == 3
    assert capsys.readouterr().err == (
        'error: this computer has no memory or descriptors left: math.so: failed to map segment from shared object\n'
    )
    with pytest.raises(ImportError, match='no such name'):
        run_quietly('damaged', 'main')
    assert signal.getsignal(signal.SIGINT) is before
