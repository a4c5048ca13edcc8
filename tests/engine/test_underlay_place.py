"""Where the underlay is, and whose a file is: known without the underlay on Python's path."""

from __future__ import annotations

import os
import sys

import pytest

from edulaunch.engine.underlay_place import engine_folder, is_students, underlay_prefix, underlay_python


@pytest.mark.parametrize(
    ('file', 'is_one'),
    [
        ('/home/anna/circle.launch.py', True),
        (os.path.join(underlay_prefix(), 'share', 'turtlesim', 'launch', 'multisim.launch.py'), True),
        (os.path.join(underlay_python(), 'launch', '__init__.py'), False),
        (os.path.join(engine_folder(), 'errors.py'), False),
        (os.__file__, False),
        (os.path.join(sys.prefix, 'lib', 'site-packages', 'numpy', '__init__.py'), False),
        ('<string>', False),
    ],
)
def test_whose_a_file_is(file: str, is_one: bool) -> None:
    assert is_students(file) is is_one
