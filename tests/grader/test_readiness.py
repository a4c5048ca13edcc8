"""Waiting for one descriptor."""

from __future__ import annotations

import fcntl
import os
import resource

import pytest
from edugrade.readiness import is_readable


@pytest.mark.parametrize('least', [3, 1100])
def test_a_descriptor_of_any_number_is_seen(least: int) -> None:
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (min(4096, hard), hard))
    reader, writer = os.pipe()
    end = fcntl.fcntl(reader, fcntl.F_DUPFD, least)
    try:
        before = is_readable(end, 0)
        os.write(writer, b'x')
        assert (before, is_readable(end, 0)) == (False, True)
    finally:
        for number in (reader, writer, end):
            os.close(number)
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
