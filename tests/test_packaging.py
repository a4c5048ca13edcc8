"""What an installation brings: types, and no notebook where nobody asked for one."""

from __future__ import annotations

import re
import sys

from tests.house import ROOT, every_import, modules

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

HEAVY = {'jupyterlab', 'nbclient', 'nbval', 'ipywidgets', 'IPython', 'pytest'}
TESTS = (
    'edulaunch.pytest_plugin',
    'edugrade.pytest_plugin',
    'edulaunch.testing',
    'launch_testing',
    'launch_pytest',
    'edulaunch.jupyter',
    'edulaunch.course',
    'edulaunch.machine.sliders',
)
"""Rooms that only pytest or a notebook loads, and test frameworks for them."""


def test_only_rooms_for_pytest_and_notebooks_need_what_the_light_install_lacks() -> None:
    wrong = [
        f'{name} imports {item}'
        for name, path in modules().items()
        for item in every_import(path)
        if item.partition('.')[0] in HEAVY and not name.startswith(TESTS)
    ]
    assert wrong == []
    required = re.search(r'\ndependencies = \[(.*?)\n\]', (ROOT / 'pyproject.toml').read_text('utf-8'), re.S)
    assert required is not None and not [name for name in HEAVY if name in required[1]]


def test_both_packages_say_that_they_have_types() -> None:
    for package in ('edulaunch', 'edugrade'):
        assert (modules()[package].parent / 'py.typed').is_file()  # .ci/run looks for them in the wheel


def test_the_wheel_brings_the_course_as_students_get_it() -> None:
    wheel = tomllib.loads((ROOT / 'pyproject.toml').read_text('utf-8'))['tool']['hatch']['build']['targets']['wheel']
    for folder in ('lessons', 'exercises'):
        assert folder in wheel['only-include'] and wheel['sources'][folder] == f'edulaunch/course/ours/{folder}'
    assert {'/lessons/.outputs', '/lessons/notes'} <= {*wheel['exclude']} and 'solutions' not in wheel['only-include']
