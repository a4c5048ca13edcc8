"""Paths in a report are short, and the same wherever it was made."""

from __future__ import annotations

from pathlib import Path

from edugrade.place import Place, is_engine, is_shipped
from edugrade.results import CheckResult
from edugrade.short_paths import ShortPaths

import edulaunch

ENGINE = str(Path(edulaunch.__file__).parent)
IMAGE = '/tmp/x/edulaunch-0/robot-0123abcd/share/'


def test_the_submissions_folder_is_shown_as_it_was_given() -> None:
    paths = ShortPaths('/home/me/work', 'work/')
    assert paths.text('at /home/me/work/a.launch.py:3') == 'at work/a.launch.py:3'
    assert paths.text('at /home/me/workshop/a.py') == 'at /home/me/workshop/a.py'


def test_the_engines_folder_is_shown_by_its_name() -> None:
    assert ShortPaths('/w').text(f'{ENGINE}/underlay/share/x') == 'edulaunch/underlay/share/x'


def test_an_installed_file_of_the_package_is_shown_as_its_source() -> None:
    paths = ShortPaths('/w/robot', 'robot/', 'robot')
    assert paths.place(Place(f'{IMAGE}robot/launch/a.launch.py', 3)) == ('robot/launch/a.launch.py', 3)
    assert paths.text(f"cannot read '{IMAGE}robot/b'") == "cannot read 'robot/b'"


def test_an_installed_file_of_another_package_is_named_after_it() -> None:
    assert ShortPaths('/w').text(f'{IMAGE}other/c.yaml') == 'other/c.yaml'


def test_all_texts_of_a_result_are_shortened() -> None:
    result = CheckResult('n', 's', 'failed', 1, (), '/w/a', '/w/b', '/w/c', Place('/w/d', 1), '/w/e')
    short = ShortPaths('/w').result(result)
    assert (short.reason, short.expected, short.seen, short.where, short.try_) == ('a', 'b', 'c', ('d', 1), 'e')
    assert ShortPaths('/w').result(CheckResult('n', 's', 'passed')).where is None


def test_shipped_launch_files_are_not_the_engine() -> None:
    assert (is_engine(f'{ENGINE}/session.py'), is_shipped(f'{ENGINE}/session.py')) == (True, True)
    shared = f'{ENGINE}/underlay/share/turtlesim/launch/multisim.launch.py'
    assert (is_engine(shared), is_shipped(shared)) == (False, True)
    assert is_shipped('/student/a.launch.py') is False
