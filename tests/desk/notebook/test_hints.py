"""What a notebook adds to "name ... is not defined"."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from edulaunch.desk.notebook.hints import _shown, candidates, missing_folder_help, missing_name_help, unfinished
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


@pytest.mark.parametrize(
    ('text', 'words'),
    [
        ('%ros2 topic l', 'topic l'),
        ('x = 1\nfound = %ros2 node ', 'node '),
        ('  %%ros2  run', 'run'),
        ('%%ros2\n  topic e', 'topic e'),
        ('%ros2x a', None),
        ('print(1)', None),
        ('%%ros2', None),
        ('a\n%%ros2\n topic', None),
    ],
)
def test_a_line_of_ros2_is_completed_and_no_line_of_python(text: str, words: str | None) -> None:
    assert unfinished(text, text.rpartition('\n')[2]) == words


@pytest.mark.parametrize(
    ('line', 'typed', 'some', 'none'),
    [
        ('', '', ['view', 'jobs', 'stop', 'wait', 'topic', 'run'], ['--for']),
        ('vi', 'vi', ['view'], ['jobs']),
        ('view ', '', ['launch', 'graph'], ['topic']),
        ('view  gr', 'gr', ['graph'], ['launch']),
        ('topic li', 'li', ['list'], ['stop']),
        ('run turtlesim --s', '--s', ['--seed'], ['--for', 'stop']),
        ('--f', '--f', [], ['--for']),
    ],
)
def test_words_of_a_line_are_completed(line: str, typed: str, some: list[str], none: list[str]) -> None:
    terminal: Any = SimpleNamespace(machine=SimpleNamespace(session=None), workspaces=list)
    before, found = candidates(terminal, line)
    assert before == typed
    assert [word for word in some if word not in found] == []
    assert [word for word in none if word in found] == []
    assert (found == sorted(set(found)) or line.startswith('view')) and all(word.startswith(typed) for word in found)


@pytest.mark.parametrize(
    ('path', 'has_help'),
    [
        ('no/x.txt', True),
        ('there/x.txt', False),
        ('x.txt', False),
        ('/no/x.txt', False),
        (Path('no/x.txt'), True),
        (3, False),
        (None, False),
    ],
)
def test_a_missing_folder_has_help(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, path: Any, has_help: bool) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'there').mkdir()
    told = "there is no folder 'no' yet: run the cells above first, because one of them creates it"
    assert missing_folder_help(path) == (told if has_help else '')


@pytest.mark.parametrize('known', ['In', 'Out', 'exit', 'quit', '_name'])
def test_names_of_the_notebook_itself_are_no_spelling_of_others(known: str) -> None:
    assert missing_name_help(f'{known}s', f'{known}s', {known: 1}).startswith('run the cell that defines')


def test_an_error_of_a_cell_is_shown_as_ipython_shows_it_with_help() -> None:
    shown: list[Any] = []
    shell: Any = SimpleNamespace(
        InteractiveTB=SimpleNamespace(structured_traceback=lambda kind, error, trace, tb_offset: [kind.__name__, f'{error}']),
        _showtraceback=lambda kind, error, lines: shown.append((kind, error, lines)),
        user_ns={},
    )
    error = FileNotFoundError(2, 'No such file or directory', 'no_such/x.txt')
    lines = _shown(shell, FileNotFoundError, error, None)  # type: ignore[arg-type]
    assert shown == [(FileNotFoundError, error, lines)]
    assert lines == ['FileNotFoundError', f'{error}\n  help: {missing_folder_help("no_such/x.txt")}']
    other = FileNotFoundError(2, 'No such file or directory', 'x.txt')
    assert _shown(shell, FileNotFoundError, other, None) == ['FileNotFoundError', f'{other}']  # type: ignore[arg-type]
