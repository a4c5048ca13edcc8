"""What a dry run assumes of commands and files of packages that are missing."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from edulaunch.advice.plan.assumptions import Assumptions


@pytest.fixture
def bin_folder(tmp_path: Path) -> str:
    """A folder with the program `there`."""
    program = tmp_path / 'bin' / 'there'
    program.parent.mkdir()
    program.write_text('#!/bin/sh\n')
    program.chmod(0o755)
    return str(program.parent)


def test_a_command_that_can_be_run_is_run_and_not_noted(bin_folder: str) -> None:
    assumed = Assumptions('/placeholders')
    assert assumed.output_of(['there', '/etc/hosts'], bin_folder) is None
    assert assumed.output_of(['ros2', 'pkg', 'list'], bin_folder) is None
    assert assumed.output_of([], bin_folder) is None
    assert assumed.others == []


def test_a_command_without_its_program_or_its_file_prints_nothing_and_is_noted(bin_folder: str) -> None:
    assumed = Assumptions('/placeholders')
    missing = os.path.join('/placeholders', 'share', 'robot', 'robot.urdf')
    assert [assumed.output_of(argv, bin_folder) for argv in (['absent', '-x'], ['there', missing])] == ['', '']
    assert len(assumed.others) == 2 and assumed.others[0] == 'output of the command absent -x'


def test_a_program_that_was_assumed_is_not_run_later(bin_folder: str) -> None:
    assumed = Assumptions('/placeholders')
    assert assumed.program('there') == 'there' and assumed.output_of(['there'], bin_folder) == ''
    assert assumed.others == ['program there', 'output of the command there']
