"""Install prefixes, and the built-in packages."""

from __future__ import annotations

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
