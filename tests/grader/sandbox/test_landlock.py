"""The places of a run: what is absent is left out, and what the computer cannot open now ends the run."""

from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest
from edugrade.sandbox.landlock import open_paths


@pytest.mark.parametrize('number', [errno.ENOMEM, errno.EMFILE, errno.EIO])
def test_a_place_that_cannot_be_opened_now_is_no_absent_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    def fails(*_: object, **__: object) -> int:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr('os.open', fails)
    with pytest.raises(OSError) as caught:
        open_paths([str(tmp_path)])
    assert caught.value.errno == number


def test_an_absent_place_is_left_out(tmp_path: Path) -> None:
    (tmp_path / 'file').touch()
    opened = open_paths([str(tmp_path / 'absent'), str(tmp_path / 'file' / 'below'), str(tmp_path)])
    assert [os.readlink(f'/proc/self/fd/{descriptor}') for descriptor in opened] == [str(tmp_path)]
    for descriptor in opened:
        os.close(descriptor)
