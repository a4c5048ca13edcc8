"""What is refused before anything runs."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.submission import LARGEST_BYTES, Submission

from edulaunch.errors import UnusableInput


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / 'circle.launch.py').write_text('x')
    monkeypatch.chdir(tmp_path)
    return tmp_path


def refusal(path: str) -> tuple[str, str | None]:
    with pytest.raises(UnusableInput) as error:
        Submission(path)
    return error.value.message, error.value.help


def test_a_missing_file_names_the_nearest(folder: Path) -> None:
    assert refusal('cirle.launch.py') == ('cirle.launch.py does not exist', 'did you mean circle.launch.py?')


def test_a_link_to_nowhere_says_where_it_points(folder: Path) -> None:
    (folder / 'mine.launch.py').symlink_to('gone.launch.py')
    assert refusal('mine.launch.py') == (
        'mine.launch.py does not exist',
        'it is a link to gone.launch.py, and that does not exist',
    )


def test_a_missing_file_in_a_missing_folder_names_the_folder(folder: Path) -> None:
    message, help = refusal('nowhere/circle.launch.py')
    assert help is not None
    assert help.startswith('the folder nowhere does not exist either')


def test_a_directory_names_its_launch_files(folder: Path) -> None:
    assert refusal('.') == ('. is a directory; edugrade grades launch files and packages', 'try one of: ./circle.launch.py')


def test_a_huge_file_is_no_launch_file(folder: Path) -> None:
    (folder / 'big.launch.py').write_bytes(b'#' * (LARGEST_BYTES + 1))
    assert refusal('big.launch.py')[0].startswith('big.launch.py is larger than 1,000,000 bytes')


def test_the_seed_changes_with_every_edit(folder: Path) -> None:
    before = Submission('circle.launch.py').seed
    assert Submission('circle.launch.py').seed == before
    (folder / 'circle.launch.py').write_text('y')
    assert Submission('circle.launch.py').seed != before
