"""A report is made again: it holds, or what is different is said."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from edugrade.classes.verify import find_submission, read_report
from edugrade.cli import main

pytestmark = pytest.mark.processes

SOLUTION = Path(__file__).parents[3] / 'solutions' / 'static_frame.launch.py'


@pytest.fixture(scope='module')
def work(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A submission with its report beside it, and the same in a class."""
    folder = tmp_path_factory.mktemp('work')
    shutil.copy(SOLUTION, folder)
    (folder / 'secret').write_text('0123456789abcdef')
    main([str(folder / SOLUTION.name), '--json', str(folder / 'report.json')])
    (folder / 'class' / 'anna').mkdir(parents=True)
    shutil.copy(SOLUTION, folder / 'class' / 'anna')
    shutil.make_archive(str(folder / 'class' / 'bert'), 'zip', folder / 'class' / 'anna')
    main(['batch', str(folder / 'class'), '--course-secret-file', str(folder / 'secret')])
    return folder


def spoilt(work: Path, change: Callable[[dict[str, Any]], object]) -> str:
    found = json.loads((work / 'report.json').read_text())
    change(found)
    (work / 'spoilt.json').write_text(json.dumps(found))
    return str(work / 'spoilt.json')


def test_a_report_holds(work: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['verify', str(work / 'report.json')]) == 0
    assert capsys.readouterr().out == f'{work}/report.json holds: static_frame: 12 of 12 points.\n'


@pytest.mark.parametrize('name', ['anna/static_frame.launch.py', 'bert.zip/static_frame.launch.py'])
def test_the_result_of_a_class_finds_its_submission(work: Path, name: str) -> None:
    words = ['verify', str(work / 'class.results' / f'{name}.json'), '--course-secret-file', str(work / 'secret')]
    assert main(words) == 0


CHANGES: dict[str, tuple[Callable[[dict[str, Any]], object], str]] = {
    'the mark': (lambda found: found['points'].update(earned=11), 'points: 11 of 12 in the report, 12 of 12 now'),
    'a check': (lambda found: found['checks'][1].update(status='failed'), 'check no_node_dies: status failed in the report'),
    'a check less': (lambda found: found['checks'].pop(), 'check frames_are_static: not in the report'),
    'a digest': (lambda found: found['scenarios'][0].update(digest='0' * 64), 'run low: digest 0000'),
    'the seed': (lambda found: found['receipt'].update(seed=7), 'run low: seed'),
    'the rubric': (lambda found: found['receipt'].update(rubric='0' * 64), 'the text of the rubric: another one'),
    'the engine': (lambda found: found['receipt'].update(edulaunch='0.0.1'), 'the version of edulaunch: another one'),
}


@pytest.mark.parametrize('name', CHANGES)
def test_what_was_changed_is_found(work: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    change, words = CHANGES[name]
    assert main(['verify', spoilt(work, change)]) == 1
    out = capsys.readouterr().out
    assert words in out and 'DOES NOT HOLD' in out


def test_another_text_is_found(work: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / SOLUTION.name).write_text(SOLUTION.read_text() + '\n# more\n')
    assert main(['verify', str(work / 'report.json'), '--submission', str(tmp_path / SOLUTION.name)]) == 1
    assert 'the text of the submission: another one' in capsys.readouterr().out


def test_a_seed_that_somebody_chose_is_found(work: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A file that is right for one seed only holds, when its author may choose the seed."""
    report = str(tmp_path / 'report.json')
    shutil.copy(SOLUTION, tmp_path)
    main([str(tmp_path / SOLUTION.name), '--seed', '7', '--json', report])
    assert main(['verify', report]) == 1
    assert 'seed: it does not follow from the text' in capsys.readouterr().out
    assert main(['verify', report, '--seed', '7']) == 0
    assert main(['verify', str(work / 'class.results' / 'anna' / 'static_frame.launch.py.json')]) == 2
    assert 'add --course-secret-file' in capsys.readouterr().err


def test_a_package_is_found_beside_its_report(tmp_path: Path) -> None:
    shutil.copytree(SOLUTION.parent / 'large_project', tmp_path / 'large_project')
    report = str(tmp_path / 'report.json')
    main([str(tmp_path / 'large_project'), '--json', report])
    assert find_submission(read_report(report), report) == str(tmp_path / 'large_project' / 'launch' / 'large_project.launch.py')


def test_a_seed_that_the_secret_did_not_choose_is_found(work: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['verify', str(work / 'report.json'), '--course-secret-file', str(work / 'secret')]) == 1
    assert 'seed: not the one that this course secret chooses' in capsys.readouterr().out


@pytest.mark.parametrize('text', ['{', '{}', '[]', '{"receipt": {}, "checks": [], "rubric": {"name": "circle"}}'])
def test_what_is_no_report_is_unusable(tmp_path: Path, text: str, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'a.json').write_text(text)
    assert main(['verify', str(tmp_path / 'a.json')]) == 2
    assert main(['verify', str(tmp_path / 'nowhere.json')]) == 2
    assert 'Traceback' not in capsys.readouterr().err


def keys(folder: Path, name: str) -> tuple[str, str]:
    pytest.importorskip('cryptography', reason='the extra "sign"')
    from cryptography.hazmat.primitives import serialization as s
    from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

    private = Ed25519PrivateKey.generate()
    (folder / name).write_bytes(private.private_bytes(s.Encoding.PEM, s.PrivateFormat.PKCS8, s.NoEncryption()))
    (folder / f'{name}.pub').write_bytes(private.public_key().public_bytes(s.Encoding.PEM, s.PublicFormat.SubjectPublicKeyInfo))
    return str(folder / name), str(folder / f'{name}.pub')


def test_a_signature_holds_until_a_word_is_changed(work: Path, capsys: pytest.CaptureFixture[str]) -> None:
    private, public = keys(work, 'mine')
    other = keys(work, 'other')[1]
    path = spoilt(work, lambda found: None)
    assert main(['verify', path, '--key', public]) == 1
    assert main(['sign', path, '--key', private]) == 0
    assert main(['verify', path, '--key', public]) == 0
    assert main(['verify', path, '--key', other]) == 1
    found = json.loads(Path(path).read_text())
    found['checks'][0]['sentence'] += '!'
    Path(path).write_text(json.dumps(found))
    capsys.readouterr()
    assert main(['verify', path, '--key', public]) == 1
    assert 'not as the owner of this key signed it' in capsys.readouterr().out
    assert main(['sign', path, '--key', public]) == 2
    assert main(['verify', path, '--key', private]) == 2
