"""Each thing that a child can send, or not send, has its words.

A recording is accepted when it is one of the scenario that was asked for.
"""

from __future__ import annotations

import json
import signal
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from edugrade import Scenario
from edugrade.evidence import Outcome
from edugrade.faults import looks_like_one
from edugrade.job import Limits
from edugrade.verdicts import recorded, verdict

import edulaunch


def judged(letter: str = '', content: object = None, **changes: Any) -> Outcome:
    """The verdict on a child that sent a frame, or none."""
    data = json.dumps(content).encode()
    frame = letter.encode() + len(data).to_bytes(8, 'big') + data if letter else b''
    run: Any = SimpleNamespace(
        **{
            'scenario': Scenario('s'),
            'limits': Limits(3.0),
            'cut': None,
            'complete': bool(letter),
            'frame': frame,
            'announced': len(data),
            'returncode': 0,
            'printed': b'',
            'refused': [],
            'sandbox': {'files': 'not here'},
            'has_begun': True,
            **changes,
        }
    )
    return verdict(run)


@pytest.mark.parametrize(
    ('cut', 'text'),
    [
        ('wall', 'the run did not finish within 3 s of real time'),
        ('printed', 'the run printed more than 4 MiB'),
        ('recording', 'the recording of the run is larger than 128 MiB'),
        ('processes', 'the run started too many programs'),
        ('disk', 'the run wrote more than 128 MiB or 4096 files'),
        ('memory', 'the run needed more than 2048 MiB of memory'),
        ('garbage', 'the run did not return a valid recording'),
    ],
)
def test_a_child_that_was_cut_off(cut: str, text: str) -> None:
    outcome = judged(cut=cut)
    assert (outcome.kind, outcome.text) == ('stopped', text)
    assert outcome.try_


def test_a_launch_file_that_cannot_run_brings_its_own_words() -> None:
    outcome = judged('U', {'text': 'no such package', 'help': 'look'})
    assert (outcome.kind, outcome.text, outcome.try_) == ('unusable', 'no such package', 'look')


def test_refused_calls_are_named() -> None:
    outcome = judged('U', {'text': 'PermissionError: [Errno 1]'}, refused=['chmod', 'utimensat'])
    assert outcome.refused == ('chmod', 'utimensat')
    assert outcome.text.splitlines()[1].startswith('The sandbox does not allow the system call chmod or utimensat. ')


def test_a_run_that_fills_its_disk_below_edulaunch_reads_the_limit() -> None:
    """The number stays in the detail, where it makes the grader test the computer."""
    said = {'text': 'OSError: [Errno 28] No space left on device', 'trace': 'OSError: [Errno 28]'}
    outcome = judged('S', {'reason': 'broken', 'said': said})
    assert (outcome.kind, outcome.text) == ('stopped', 'the run wrote more than 128 MiB or 4096 files')
    assert looks_like_one(outcome)


def test_a_broken_engine_is_no_students_fault() -> None:
    outcome = judged('B', {'text': 'KeyError: 1', 'trace': 'Traceback'})
    assert (outcome.kind, outcome.detail) == ('broke', 'Traceback')


def test_a_timeout_names_the_line_where_it_was() -> None:
    outcome = judged('S', {'reason': 'timeout', 'file': '/a.py', 'line': 3})
    assert outcome.where == ('/a.py', 3)


def test_memory_is_named() -> None:
    assert judged('S', {'reason': 'memory'}).text == 'the run needed more than 2048 MiB of memory'


@pytest.mark.parametrize(('letter', 'content'), [('S', {'reason': 'x'}), ('U', [1]), ('B', 'text'), ('R', {})])
def test_what_makes_no_sense_is_no_recording(letter: str, content: object) -> None:
    assert judged(letter, content).text == 'the run did not return a valid recording'


@pytest.mark.parametrize(
    ('code', 'text'),
    [
        (0, 'the program ended itself with exit code 0 before the end of the run'),
        (None, 'the program ended itself before the end of the run'),
        (-signal.SIGKILL, 'SIGKILL ended the program before the end of the run'),
        (-99, 'signal 99 ended the program before the end of the run'),
        (-signal.SIGXCPU, 'a single call used the processor for seconds and did not return'),
    ],
)
def test_a_child_that_ended_says_how(code: int | None, text: str) -> None:
    assert judged(returncode=code).text == text


def test_what_it_printed_is_kept_for_the_course_author() -> None:
    assert judged(printed=b'words').detail == 'words'


def test_what_must_be_confined_and_is_not_gets_no_mark() -> None:
    open_files = {'files': 'Function not implemented', 'network': 'held'}
    outcome = judged(limits=Limits(3.0, sandbox='require'), sandbox=open_files)
    assert (outcome.kind, outcome.text) == ('broke', 'this system has no complete sandbox: files (Function not implemented)')
    assert judged(limits=Limits(3.0), sandbox=open_files).kind == 'stopped'
    assert judged(limits=Limits(3.0), sandbox=open_files).sandbox == open_files


def test_a_guard_that_was_killed_from_outside_costs_no_mark() -> None:
    for how in ({'sandbox': {'files': 'held'}}, {'sandbox': None, 'has_begun': False}):
        outcome = judged(returncode=None, **how)
        assert (outcome.kind, outcome.text) == ('broke', 'another program killed a process of the grader')


SCENARIO = Scenario('s', {}, 0.2, 3)


@pytest.fixture(scope='module')
def content() -> bytes:
    return (
        b'[{"nodes": [1], "parameters": [], "logs": [], "output": []}, [[1, "turtlesim", "turtlesim_node"]]]\n'
        + edulaunch.run('turtlesim', 'multisim.launch.py', duration_s=0.2, seed=3).to_bytes()
    )


def failed(tmp_path: Path, text: str) -> bytes:
    """The recording of a launch file that fails."""
    file = tmp_path / 'a.launch.py'
    file.write_text(text)
    with edulaunch.Session(seed=3) as session:
        session.launch(str(file))
        session.run(0.2)
        return b'[{"nodes": [], "parameters": [], "logs": [], "output": []}, []]\n' + session.recording().to_bytes()


def test_a_recording_of_the_scenario_is_accepted(content: bytes) -> None:
    outcome = recorded(SCENARIO, content)
    assert outcome is not None
    assert outcome.kind == 'recorded' and outcome.recording is not None
    assert outcome.recording.owners is not None and outcome.recording.owners['nodes'] == [1]
    assert outcome.recording.hosted == {1: ('turtlesim', 'turtlesim_node')}


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
    assert (outcome.kind, outcome.text) == ('stopped', 'launch ended with exit code 0 before it started a program')
