"""The folder of links that stands for a build, when several processes use it at once."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

USER = """import os, sys
from edulaunch.engine.packages.workspace import Image

lost = []
for _ in range(300):
    image = Image(sys.argv[1])
    try:
        folder = image.add_folder('lib/robo')
        if not os.path.isdir(folder):
            lost.append(folder)
    except OSError as error:
        lost.append(str(error))
    del image
sys.exit('\\n'.join(lost[:3]) or 0)
"""


@pytest.mark.processes
def test_a_process_that_ends_does_not_remove_the_folder_that_another_one_claims(tmp_path: Path) -> None:
    command = [sys.executable, '-c', USER, str(tmp_path / 'robo_ws')]
    users = [subprocess.Popen(command, stderr=subprocess.PIPE, text=True) for _ in range(4)]
    assert [(user.communicate()[1], user.returncode) for user in users] == [('', 0)] * 4
