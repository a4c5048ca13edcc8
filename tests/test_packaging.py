"""What an installation brings: types, and no notebook where nobody asked for one."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys

import pytest

from edulaunch.runtime.version import __version__
from tests.house import ROOT, every_import, modules

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

KINDS_OF_CHANGE = {'Added', 'Changed', 'Deprecated', 'Removed', 'Fixed', 'Security'}
TOP = {
    *(
        'COLCON_IGNORE',
        '.ci',
        '.git-blame-ignore-revs',
        '.github',
        '.gitignore',
        'CHANGELOG.md',
        'CITATION.cff',
        'CODE_OF_CONDUCT.md',
        'LICENSE',
        'README.md',
        'SECURITY.md',
        'constraints.txt',
        'hashes.txt',
        'mkdocs.yml',
        'pyproject.toml',
        'setup.sh',
    ),
    *('docs', 'edulaunch', 'exercises', 'grader', 'lessons', 'solutions', 'tests'),
}
HEAVY = {'jupyterlab', 'nbclient', 'nbval', 'ipywidgets', 'IPython', 'pytest'}
TESTS = (
    'edulaunch.extras.pytest_plugin',
    'edugrade.pytest_plugin',
    'edulaunch.extras.testing',
    'launch_testing',
    'launch_pytest',
    'edulaunch.desk.notebook',
    'edulaunch.course',
    'edulaunch.desk.machine.sliders',
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


def test_nothing_lies_at_the_top_that_does_not_belong_there() -> None:
    """What programs write where they are tried out (rosbag2_*, *.results) does not become a part of the project."""
    if not (ROOT / '.git').exists() or not (git := shutil.which('git')):
        pytest.skip('no git here, so that nobody can say what belongs to the project')
    kept = subprocess.run([git, '-C', str(ROOT), 'ls-files'], capture_output=True, text=True, check=True).stdout.split('\n')
    assert {name.partition('/')[0] for name in kept if name} <= TOP


def test_the_hashes_are_those_of_the_pinned_packages_and_all_are_there() -> None:
    """`pip install -c constraints.txt -e .` cannot have hashes: pip refuses them for a folder. So they are in a file of their own."""
    pins = set(re.findall(r'^([\w.-]+==[\w.]+)', (ROOT / 'constraints.txt').read_text('utf-8'), re.M))
    blocks = re.split(r'\n(?=\w)', (ROOT / 'hashes.txt').read_text('utf-8').strip())
    locked = {block.partition(' ')[0] for block in blocks}
    assert locked <= pins
    assert [block for block in blocks if '--hash=sha256:' not in block] == []
    required = tomllib.loads((ROOT / 'pyproject.toml').read_text('utf-8'))['project']['dependencies']
    assert {re.split('[>=;]', line)[0].lower() for line in required} <= {line.partition('==')[0] for line in locked}


def test_the_version_says_what_the_classifier_says() -> None:
    """A stable version has a changelog entry of at most 60 lines."""
    project = tomllib.loads((ROOT / 'pyproject.toml').read_text('utf-8'))['project']
    assert 'Development Status :: 5 - Production/Stable' in project['classifiers'] and int(__version__.split('.')[0]) >= 1
    entries = re.split(r'^## ', (ROOT / 'CHANGELOG.md').read_text('utf-8'), flags=re.M)[1:]
    of_it = [entry for entry in entries if entry.startswith(f'[{__version__}]')]
    assert len(of_it) == 1 and of_it[0].strip().count('\n') <= 60
    assert {name for entry in entries for name in re.findall(r'^### (.*)$', entry, re.M)} <= KINDS_OF_CHANGE
