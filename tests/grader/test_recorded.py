"""A recording is accepted when it is one of the scenario that was asked for."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade import Scenario
from edugrade.recorded import recorded

import edulaunch

SCENARIO = Scenario('s', {}, 0.2, 3)


@pytest.fixture(scope='module')
def content() -> bytes:
    return b'[[0], []]\n' + edulaunch.run('turtlesim', 'multisim.launch.py', duration_s=0.2, seed=3).to_bytes()


def failed(tmp_path: Path, text: str) -> bytes:
    """The recording of a launch file that fails."""
    file = tmp_path / 'a.launch.py'
    file.write_text(text)
    with edulaunch.Session(seed=3) as session:
        session.launch(str(file))
        session.run(0.2)
        return b'[[], []]\n' + session.recording().to_bytes()


def test_a_recording_of_the_scenario_is_accepted(content: bytes) -> None:
    outcome = recorded(SCENARIO, content)
    assert outcome is not None
    assert outcome.kind == 'recorded' and outcome.recording is not None
    assert outcome.recording.hosted_nodes == {0}


@pytest.mark.parametrize('other', [SCENARIO._replace(seed=4), SCENARIO._replace(arguments={'x': '1'})])
def test_a_recording_of_another_run_is_refused(content: bytes, other: Scenario) -> None:
    assert recorded(other, content) is None


@pytest.mark.parametrize('noise', [b'', b'12345', b'{}', b'[[], []]\n{}', b'[]\n{}', b'\xff' * 100])
def test_noise_is_refused(noise: bytes) -> None:
    assert recorded(SCENARIO, noise) is None


def test_a_launch_file_that_fails_is_unusable_and_its_line_is_named(tmp_path: Path) -> None:
    outcome = recorded(SCENARIO, failed(tmp_path, 'x = 1\nraise ValueError("no")\n'))
    assert outcome is not None
    assert (outcome.kind, outcome.where) == ('unusable', (str(tmp_path / 'a.launch.py'), 2))
    assert 'ValueError: no' in outcome.text
    assert str(tmp_path / 'a.launch.py:2') not in outcome.text


def test_a_launch_that_starts_nothing_did_not_run(tmp_path: Path) -> None:
    text = 'from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription([])\n'
    outcome = recorded(SCENARIO, failed(tmp_path, text))
    assert outcome is not None
    assert (outcome.kind, outcome.text) == ('stopped', 'launch ended with exit code 0 and had started nothing')
