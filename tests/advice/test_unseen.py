"""Mistakes of beginners that were written down before the rules were read, each with a healthy twin.

`unseen/NAME/expected.txt` says what the mistake is, which words the first report of its run must have (`says:`, regular expressions)
and which no report may have (`never:`).
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import edulaunch
from edulaunch.errors import LaunchFileError

pytestmark = pytest.mark.filterwarnings('ignore::UserWarning')  # a student's program warns and goes on
UNSEEN = Path(__file__).parent / 'unseen'
NAMES = sorted(path.name for path in UNSEEN.iterdir())
EACH = [pytest.param(name, marks=[] if number % 8 == 0 else pytest.mark.whole) for number, name in enumerate(NAMES)]
"""One in eight is a unit test. All of them are a third of the time of all unit tests, and are run by `.ci/run`."""
SECONDS = 8.0


def reports(file: Path) -> list[str]:
    """What a run reports; of a launch file that cannot be launched, its error."""
    workspaces = [file.parent] if list(file.parent.glob('*/package.xml')) else []
    try:
        return edulaunch.run(file, duration_s=SECONDS, workspaces=workspaces, console=lambda *_: None).warnings
    except LaunchFileError as error:
        return [str(error)]


def main_of(name: str, side: str) -> Path:
    """Return the launch file of one side, in Python, XML or YAML."""
    return next((UNSEEN / name / side).glob('main.launch.*'))


def lines(name: str, label: str) -> list[str]:
    text = (UNSEEN / name / 'expected.txt').read_text(encoding='utf-8')
    return [line.removeprefix(f'{label}: ') for line in text.splitlines() if line.startswith(f'{label}: ')]


@pytest.mark.parametrize('name', EACH)
def test_the_first_report_names_the_mistake(name: str) -> None:
    found = reports(main_of(name, 'failing'))
    assert found and all(re.search(words, found[0]) for words in lines(name, 'says')), found
    assert not [report for report in found for words in lines(name, 'never') if re.search(words, report)]


@pytest.mark.parametrize('name', EACH)
def test_nothing_is_reported_of_the_healthy_twin(name: str) -> None:
    assert reports(main_of(name, 'healthy')) == []
