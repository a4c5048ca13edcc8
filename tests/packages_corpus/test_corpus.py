"""Every package of the corpus does here, second by second, what it does with ROS 2; and the same again in every run."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from .cases import CASES, CORPUS
from .journal import journal, run_case

HERE = Path(__file__).resolve().parent
PROGRAM = """
import sys
sys.path.insert(0, {root!r})
from tests.packages_corpus.cases import CASES
from tests.packages_corpus.journal import run_case
for name, case in CASES.items():
    for seed in {seeds} if case.random else (0,):
        print(name, seed, run_case(name, seed).digest())
"""


def expected(name: str) -> list[str]:
    """The lines that must come; comments are left out."""
    text = (HERE / 'expected' / f'{name}.txt').read_text(encoding='utf-8')
    return [line for line in text.splitlines() if not line.startswith('#')]


def with_wildcards(lines: list[str], wanted: list[str]) -> list[str]:
    """A wanted line that ends with ` ...` fits every line that begins so (texts that differ between Python versions)."""
    fits = [want.endswith(' ...') and line.startswith(want[:-4]) for line, want in zip(lines, wanted, strict=False)]
    return [want if fit else line for line, want, fit in zip(lines, wanted, fits, strict=False)] + lines[len(fits) :]


HERE_TOO: dict[tuple[str, str], str] = {}
"""Digests of the runs in this process, by (package, seed)."""


@pytest.mark.parametrize('name', CASES)
def test_a_package_does_what_it_does_with_ros(name: str) -> None:
    wanted, recording = expected(name), run_case(name)
    HERE_TOO[name, '0'] = recording.digest()
    assert with_wildcards(journal(recording, name), wanted) == wanted


def test_every_package_is_run_and_every_expectation_is_used() -> None:
    folders = sorted(path.name for path in CORPUS.iterdir() if path.is_dir() and path.name[0] != '.')
    assert folders == sorted(CASES) == sorted(path.stem for path in (HERE / 'expected').iterdir())


@pytest.fixture(scope='module')
def digests(tmp_path_factory: pytest.TempPathFactory) -> dict[tuple[str, str], str]:
    """By (package, seed), from a process with another hash seed and a temporary folder of its own, as on another machine."""
    other = '1' if os.environ.get('PYTHONHASHSEED') != '1' else '2'
    done = subprocess.run(
        [sys.executable, '-c', PROGRAM.format(root=str(HERE.parents[1]), seeds=(0, 1))],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        check=True,
        env={**os.environ, 'PYTHONHASHSEED': other, 'TMPDIR': str(tmp_path_factory.mktemp('tmp'))},
    )
    return {(name, seed): digest for name, seed, digest in map(str.split, done.stdout.splitlines())}


@pytest.mark.whole
def test_every_run_is_the_same_in_another_process(digests: dict[tuple[str, str], str]) -> None:
    here = {(name, '0'): HERE_TOO.get((name, '0')) or run_case(name).digest() for name in CASES}
    assert [key for key in here if here[key] != digests[key]] == []


@pytest.mark.whole
@pytest.mark.parametrize('name', [name for name, case in CASES.items() if case.random])
def test_another_seed_gives_another_run(name: str, digests: dict[tuple[str, str], str]) -> None:
    assert digests[name, '0'] != digests[name, '1']
