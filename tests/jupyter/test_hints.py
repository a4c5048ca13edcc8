"""What a notebook adds to "name ... is not defined"."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.jupyter.hints import missing_name_help
from tests.lessons.student import Student

HERE = {'square': 1, '_hidden': 2}


@pytest.mark.parametrize(
    ('name', 'line', 'told'),
    [
        ('no', "predict('turtles-move', no)", "a word stands in quotes: 'no'"),
        (
            'compare',
            "compare('blue', 255)",
            'the first cell of this lesson brings it: run that cell, after each restart of the kernel',
        ),
        (
            'edulaunch',
            'edulaunch.run(1)',
            'the first cell of this lesson brings it: run that cell, after each restart of the kernel',
        ),
        (
            'one',
            "compare('half-circle', one.frames_at(6.8))",
            'the cell that makes one has not been run, or ended with an error: run it first, and look at what it says',
        ),
        ('check', "check('circle')", 'write above it: from edulaunch import check'),
        ('sqare', 'sqare.replay()', 'write square, if that is the one you mean'),
        (
            'colour',
            'colour.replay()',
            'the cell that makes colour has not been run, or ended with an error: run it first, and look at what it says',
        ),
        ('', '', ''),
    ],
)
def test_the_help_names_what_to_do(name: str, line: str, told: str) -> None:
    assert missing_name_help(name, line, HERE) == told


def test_a_cell_out_of_order_keeps_the_error_of_python_and_says_what_to_do(tmp_path: Any) -> None:
    told = Student('01_first_launch', tmp_path).walk('set-up square-picture', {})
    assert "NameError: name 'square' is not defined\n  help: the cell that makes square has not been run" in told


def test_an_error_inside_a_library_is_not_ours_to_explain(tmp_path: Any) -> None:
    code = "import types\nelse_where = types.ModuleType('else_where')\nexec('def f(): return nowhere', else_where.__dict__)\nelse_where.f()"
    told = Student('01_first_launch', tmp_path).walk('set-up added', {'added': code})
    assert "name 'nowhere' is not defined" in told and 'help: ' not in told
