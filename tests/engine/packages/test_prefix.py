"""Install prefixes, and the built-in packages."""

from __future__ import annotations

import builtins
import errno
import os
from pathlib import Path

import pytest

from edulaunch.engine.packages.prefix import Underlay


def test_the_underlay_is_looked_through_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'share' / 'shapes' / 'msg').mkdir(parents=True)
    (tmp_path / 'share' / 'licences').mkdir()
    assert (Underlay(str(tmp_path)).packages(), Underlay(str(tmp_path)).interface_packages()) == (['shapes'], ['shapes'])
    monkeypatch.setattr(os, 'listdir', lambda path: pytest.fail(f'{path} is listed again'))
    assert (Underlay(str(tmp_path)).packages(), Underlay(str(tmp_path)).interface_packages()) == (['shapes'], ['shapes'])


def test_a_moment_without_memory_is_no_package_without_programs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'share' / 'robo').mkdir(parents=True)
    (tmp_path / 'share' / 'robo' / 'console_scripts.txt').write_text('drive = robo.drive:main\n')
    underlay = Underlay(str(tmp_path))

    def fails(*arguments: object, **options: object) -> object:
        raise OSError(errno.ENOMEM, os.strerror(errno.ENOMEM))

    with monkeypatch.context() as moment:
        moment.setattr(builtins, 'open', fails)
        with pytest.raises(OSError, match='Cannot allocate memory'):
            underlay.executables('robo')
    assert underlay.executables('robo') == ['drive']
    assert underlay.executables('other') == []
