"""Edits: of a word that is written twice there is none; lists of setup.py and lines of package.xml; edits made together."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.advice.rule import found
from edulaunch.advice.texts import Text, check
from edulaunch.advice.texts.edits import applied, edits_of, inserted

SETUP = """from setuptools import find_packages, setup

package_name = 'patrol'

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    entry_points={
        'console_scripts': [
        ],
    },
)
"""
MANIFEST = """<?xml version="1.0"?>
<package format="3">
  <name>patrol</name>
  <version>0.0.0</version>
  <description>x</description>
  <maintainer email="a@b.c">a</maintainer>
  <license>MIT</license>

  <exec_depend>rclpy</exec_depend>

  <export>
    <build_type>ament_python</build_type>
  </export>
</package>
"""


def test_a_word_that_is_written_twice_gives_no_edit() -> None:
    finding = found('file', 'a', file='/a.launch.py', line=1, keyword='mgs', near='msg')._replace(rule='launch.keyword')
    assert [edit.new for edit in edits_of(finding, Text("LogInfo(mgs='a')\n", '/a.launch.py'))] == ['msg=']
    assert edits_of(finding, Text("LogInfo(mgs='a', **dict(mgs='b'))\n", '/a.launch.py')) == ()


def test_a_suggestion_that_is_not_near_gives_no_edit() -> None:
    for near, count in (('turtle', 1), ('tower', 0)):
        finding = found('file', 'a', line=1, configuration='turtel', near=near)._replace(rule='launch.no-configuration')
        assert len(edits_of(finding, Text("LaunchConfiguration('turtel')\n", '/a.launch.py'))) == count


def test_the_keyword_may_be_on_a_later_line_of_the_call() -> None:
    finding = found('file', 'a', file='/a.launch.py', line=1, keyword='mgs', near='msg')._replace(rule='launch.keyword')
    text = "LogInfo(\n    mgs='a',\n)\n"
    assert applied(text, edits_of(finding, Text(text, '/a.launch.py'))) == "LogInfo(\n    msg='a',\n)\n"


def test_edits_are_made_from_the_end_and_only_where_the_old_text_is() -> None:
    text = Text('a b c', 'x')
    assert applied('a b c', (inserted(text, 0, '0'), inserted(text, 5, '9'))) == '0a b c9'
    (edit,) = edits_of(found('file', 'a', line=1, keyword='a', near='b')._replace(rule='launch.keyword'), Text('f(a=1)', 'x'))
    assert applied('f(a=1)', (edit,)) == 'f(b=1)'
    assert applied('f(c=1)', (edit,)) == 'f(c=1)'


@pytest.fixture
def package(tmp_path: Path) -> Path:
    folder = tmp_path / 'patrol'
    for name, text in (
        ('package.xml', MANIFEST),
        ('setup.py', SETUP),
        ('setup.cfg', '[develop]\nscript_dir=$base/lib/patrol\n[install]\ninstall_scripts=$base/lib/patrol\n'),
        ('resource/patrol', ''),
        ('patrol/__init__.py', ''),
        ('patrol/walk.py', 'import rclpy\ndef main():\n    rclpy.init()\n'),
        ('launch/walk.launch.py', 'from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription([])\n'),
    ):  # fmt: skip
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding='utf-8')
    return folder


def test_lines_that_setup_py_and_package_xml_lack(package: Path) -> None:
    from edulaunch.advice.judging import judge_sources

    setup, manifest = Text(SETUP, str(package / 'setup.py')), Text(MANIFEST, str(package / 'package.xml'))
    made, described = SETUP, MANIFEST
    for finding in judge_sources(str(package)):
        made = applied(made, edits_of(finding, Text(made, setup.path))) if finding.rule != 'packages.launch-not-named' else made
        described = applied(described, edits_of(finding, manifest)) if finding.rule == 'packages.launch-not-named' else described
    assert "'walk = patrol.walk:main'" in made and 'import os\nfrom glob import glob\n' in made
    assert "        (os.path.join('share', package_name, 'launch'), glob('launch/*launch.[pxy][yma]*')),\n    ],\n" in made
    assert '  <exec_depend>rclpy</exec_depend>\n  <exec_depend>ros2launch</exec_depend>\n\n' in described
    (package / 'setup.py').write_text(made, encoding='utf-8')
    (package / 'package.xml').write_text(described, encoding='utf-8')
    assert judge_sources(str(package)) == []


def test_a_misspelt_module_of_an_entry_point_is_cured_in_the_unsaved_text(package: Path) -> None:
    text = SETUP.replace("'console_scripts': [\n", "'console_scripts': ['walk = patrol.wlak:main'\n")
    mark = next(one for one in check(text, str(package / 'setup.py')) if one.finding.rule == 'packages.entry-point-module')
    assert text[mark.span.start : mark.span.end] == 'patrol.wlak'
    assert "'walk = patrol.walk:main'" in applied(text, mark.edits)
    assert (package / 'setup.py').read_text(encoding='utf-8') == SETUP
