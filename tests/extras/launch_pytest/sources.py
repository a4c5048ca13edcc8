"""Fixtures that test files of a few lines begin with."""

from __future__ import annotations

ALIVE = """
@launch_pytest.fixture
def alive():
    return launch.LaunchDescription([KeepAliveProc(), ReadyToTest()])
"""


SHARED = """
@pytest.fixture(scope='module')
def proc():
    return KeepAliveProc()
@launch_pytest.fixture(scope='module')
def shared(proc):
    return launch.LaunchDescription([proc, ReadyToTest()])
"""
