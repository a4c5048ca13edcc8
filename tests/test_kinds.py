"""Every test runs in exactly one step of `.ci/run`, and unit tests start no Python."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from functools import cache
from pathlib import Path
from types import ModuleType

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.house import ROOT
from tests.kinds import ALL_TESTS, KINDS, has_none_of, kinds_of

RUN = (ROOT / '.ci' / 'run').read_text(encoding='utf-8')
UNIT_TESTS = 'of_the_readme tests'
"""How `.ci/run` finds the README's command, which leaves out every kind."""


@cache
def steps() -> list[tuple[str, list[str]]]:
    """(expression of marks, folders) of the calls of pytest in `.ci/run`, but for lessons, and for what installs a second Python."""
    calls = re.findall(r'(?m)^[^#\n]*\b(?:pytest|hurried \w+) (-[^;\n]*)$|\{ (?:pytest|hurried \w+) ([^;]*);', RUN)
    found = []
    for call in (' '.join(both).strip() for both in calls):
        marks = re.search(r"-m (?:'([^']*)'|(\w+))", call)
        if '--nbval' not in call and '@' not in call and 'cacheprovider' not in call:
            found.append(((marks[1] or marks[2]) if marks else '', re.findall(r'\btests/\w+', call)))
    return found


def runs(item: pytest.Item, marks: str, folders: list[str]) -> bool:
    """Whether a step runs a test."""
    if folders and not any(item.nodeid.startswith(f'{folder}/') for folder in folders):
        return False
    kinds = kinds_of(item)
    return not marks or bool(eval(marks, {'__builtins__': {}}, {kind: kind in kinds for kind in KINDS}))


def test_the_steps_are_found() -> None:
    assert UNIT_TESTS in RUN
    assert ('', ['tests/browser']) in steps()
    assert {kind for kind in KINDS for marks, folders in steps() if kind in marks or folders == [f'tests/{kind}']} == set(KINDS)


def test_every_test_runs_in_one_step_and_no_other(request: pytest.FixtureRequest) -> None:
    """Of all that was collected with this one; of the whole house where the README's command runs."""
    wrong = []
    for item in request.config.stash[ALL_TESTS]:
        where = [step for step in steps() if runs(item, *step)]
        if len(where) + (not kinds_of(item)) != 1:
            wrong.append((item.nodeid, where))
    assert wrong == []


def test_a_file_is_left_out_only_where_it_names_no_mark_that_is_asked_for(tmp_path: Path) -> None:
    file, helper = tmp_path / 'test_a.py', tmp_path / 'helper.py'
    file.write_text('from edulaunch.engine import processes\n\n@pytest.mark.whole\ndef test_all(): ...\n')
    helper.write_text('')
    asked = ('whole', 'processes or whole', 'processes', 'processes or real', '', 'not whole', 'whole and real')
    assert [has_none_of(file, each) for each in asked] == [False, False, True, True, False, False, False]
    assert not has_none_of(helper, 'whole')
    (tmp_path / 'conftest.py').write_text('def pytest_collection_modifyitems(items): items[0].add_marker(pytest.mark.real)\n')
    assert not has_none_of(file, 'real')


def test_the_file_of_each_test_names_its_mark(request: pytest.FixtureRequest) -> None:
    """Else `-m` would leave it out with its file."""
    steps_of_marks = {kind for marks, _ in steps() for kind in marks.split(' or ')}
    marked = ((item, kind) for item in request.config.stash[ALL_TESTS] for kind in kinds_of(item) if kind in steps_of_marks)
    assert [item.nodeid for item, kind in marked if has_none_of(item.path, kind)] == []


def test_a_python_that_a_unit_test_starts_fails_it() -> None:
    with pytest.raises(pytest.fail.Exception, match='processes'):
        subprocess.run([sys.executable, '-c', ''])
    with pytest.raises(pytest.fail.Exception, match='processes'):
        os.posix_spawn(sys.executable, [sys.executable, '-c', ''], {})


def test_another_program_may_be_started() -> None:
    assert subprocess.run(['true']).returncode == 0


def test_each_path_in_the_steps_is_there() -> None:
    words = re.findall(r'(?<!\S)tests/[\w./*\[\]!{},-]+', RUN)
    spread = [
        f'{found[1]}{choice}{found[3]}'
        for word in words
        if (found := re.match(r'(.*)\{(.*)\}(.*)', word))
        for choice in found[2].split(',')
    ]
    plain = [word.rstrip(';') for word in words if '{' not in word]
    assert not [word for word in plain + spread if not list(ROOT.glob(word))]
    assert spread  # the braces are read


def test_a_property_meets_the_same_examples_whatever_is_loaded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    module = ModuleType('many_texts')
    module.__file__ = str(tmp_path / 'many_texts.py')
    Path(module.__file__).write_text(repr([f'text {number}' for number in range(400)]))
    first = texts()
    monkeypatch.setitem(sys.modules, 'many_texts', module)
    assert texts() == first and len(set(first)) > 20


def texts() -> list[str]:
    met: list[str] = []
    given(st.text())(lambda text: met.append(text))()
    return met
