"""The command begins a starter before it loads its own modules, and leaves nothing of one that no runner takes."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from edugrade import Scenario, starter_link
from edugrade.commands import edugrade, has_runs
from edugrade.runner import Runner
from edugrade.submission import Submission

from edulaunch.runtime.quiet_start import run_quietly


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'temporary').mkdir()
    monkeypatch.setenv('TMPDIR', str(tmp_path / 'temporary'))
    (tmp_path / 'circle.launch.py').write_text('')


@pytest.mark.parametrize(
    ('words', 'wanted'),
    [
        ('circle.launch.py', True),
        ('--sandbox off circle.launch.py', True),
        ('batch circle.launch.py', False),
        ('--help', False),
        ('other.launch.py', False),
        ('', False),
    ],
)
def test_which_command_lines_have_runs(words: str, wanted: bool) -> None:
    assert has_runs(words.split()) is wanted


@pytest.mark.processes
def test_a_runner_takes_the_early_starter_once(tmp_path: Path) -> None:
    starter_link.start_early()
    (early,) = os.listdir(tmp_path / 'temporary')
    with Runner() as first, Runner() as second:
        assert first._home == str(tmp_path / 'temporary' / early)
        assert first._starter is not None and first._starter.is_alive
        assert second._home != first._home and second._starter is None
    assert os.listdir(tmp_path / 'temporary') == []


@pytest.mark.processes
def test_a_starter_for_many_runs_has_loaded_more_and_gives_the_same_recording(tmp_path: Path) -> None:
    file = tmp_path / 'a.launch.py'
    file.write_text('import sys\nraise RuntimeError("loaded" if "yaml" in sys.modules else "not loaded")\n')
    solution = str(Path(__file__).resolve().parents[2] / 'solutions' / 'circle.launch.py')
    said, digests = [], []
    for is_for_many in (False, True):
        with Runner(processors=1, is_for_many=is_for_many) as runner:
            asked, right = (runner.add(Submission(path), [Scenario('s', {}, 2.0, 7)]) for path in (str(file), solution))
            said.append('not loaded' not in runner.wait(asked)[0].text)
            recording = runner.wait(right)[0].recording
            assert recording is not None
            digests.append(recording.digest())
    assert said == [False, True]
    assert digests[0] == digests[1]


@pytest.mark.processes
def test_nothing_is_left_of_a_starter_that_no_runner_takes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    made: list[str] = []

    def loaded(module: str, name: str, broken: int) -> int:
        made.extend(os.listdir(tmp_path / 'temporary'))
        return run_quietly(module, name, broken)

    monkeypatch.setattr('edugrade.commands.run_quietly', loaded)
    monkeypatch.setattr('sys.argv', ['edugrade', '--no-such-option', 'circle.launch.py'])
    with pytest.raises(SystemExit):
        edugrade()
    assert len(made) == 1
    assert os.listdir(tmp_path / 'temporary') == []


def test_without_a_folder_there_is_no_early_starter(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('TMPDIR', str(tmp_path / 'missing'))
    starter_link.start_early()
    assert starter_link.take_early() is None
