from __future__ import annotations

import os
from pathlib import Path

import pytest

from edulaunch.extras.comparing.isolated import in_isolation


def test_a_run_finds_what_is_here_and_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    here = tmp_path / 'here'
    here.mkdir()
    (here / 'speeds.yaml').write_text('fast')
    (tmp_path / 'beside').mkdir()
    (tmp_path / 'beside' / 'x.txt').write_text('found')
    monkeypatch.chdir(here)

    def run(name: str, *, text: str) -> list[str]:
        os.mkdir(name)
        assert os.getcwd() != str(here)
        return [text, Path('speeds.yaml').read_text(), Path('../beside/x.txt').read_text()]

    for _ in range(2):
        assert in_isolation(run, 'my_drive', text='well') == ['well', 'fast', 'found']
    with pytest.raises(ZeroDivisionError):
        in_isolation(lambda: 1 / 0)
    assert os.getcwd() == str(here)
    assert sorted(path.name for path in here.iterdir()) == ['speeds.yaml']
