"""What a notebook adds to "name ... is not defined"."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.desk.notebook.hints import missing_name_help
from tests.lessons.student import Student

HERE = {'square': 1, '_hidden': 2}


@pytest.mark.parametrize(
    ('name', 'line', 'told'),
    [
        ('no', "predict('turtles-move', no)", "put a string in quotation marks: 'no'"),
        (
            'compare',
            "compare('blue', 255)",
            'run the first cell of this lesson, which defines this name; run it again after each restart of the kernel',
        ),
        (
            'edulaunch',
            'edulaunch.run(1)',
            'run the first cell of this lesson, which defines this name; run it again after each restart of the kernel',
        ),
        (
            'one',
            "compare('half-circle', one.frames_at(6.8))",
            'run the cell that defines one first; if it ends with an error, fix that error',
        ),
        ('check', "check('circle')", 'write this line above: from edulaunch import check'),
        ('sqare', 'sqare.replay()', 'did you mean square?'),
        ('colour', 'colour.replay()', 'run the cell that defines colour first; if it ends with an error, fix that error'),
        ('', '', ''),
    ],
)
def test_the_help_names_what_to_do(name: str, line: str, told: str) -> None:
    assert missing_name_help(name, line, HERE) == told


def test_a_cell_out_of_order_keeps_the_error_of_python_and_says_what_to_do(tmp_path: Any) -> None:
    told = Student('01_first_launch', tmp_path).walk('set-up square-picture', {})
    assert "NameError: name 'square' is not defined\n  help: run the cell that defines square first" in told


def test_an_error_inside_a_library_is_not_ours_to_explain(tmp_path: Any) -> None:
    code = "import types\nelse_where = types.ModuleType('else_where')\nexec('def f(): return nowhere', else_where.__dict__)\nelse_where.f()"
    told = Student('01_first_launch', tmp_path).walk('set-up added', {'added': code})
    assert "name 'nowhere' is not defined" in told and 'help: ' not in told
