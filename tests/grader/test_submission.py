"""What is refused before anything runs.

A package as a submission: which it is, where its workspace is, what belongs to it.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.submission import LARGEST_BYTES, Submission, package_above, package_at

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
    assert refusal('.') == ('. is a folder; edugrade grades launch files and packages', 'try one of: ./circle.launch.py')


def test_a_huge_file_is_no_launch_file(folder: Path) -> None:
    (folder / 'big.launch.py').write_bytes(b'#' * (LARGEST_BYTES + 1))
    assert refusal('big.launch.py')[0].startswith('big.launch.py is larger than 1,000,000 bytes')


def test_the_seed_changes_with_every_edit(folder: Path) -> None:
    before = Submission('circle.launch.py').seed
    assert Submission('circle.launch.py').seed == before
    (folder / 'circle.launch.py').write_text('y')
    assert Submission('circle.launch.py').seed != before


@pytest.fixture
def package(tmp_path: Path) -> Path:
    folder = tmp_path / 'ws' / 'src' / 'my_copy'
    (folder / 'launch').mkdir(parents=True)
    (folder / 'config').mkdir()
    (folder / 'package.xml').write_text('<package><name>robot</name></package>')
    (folder / 'launch' / 'robot.launch.py').write_text('# TODO 2: b\n')
    (folder / 'config' / 'a.yaml').write_text('# TODO 1: a\n')
    return folder


def test_a_package_is_known_by_its_manifest(package: Path) -> None:
    found = package_at(str(package))
    assert found is not None
    assert (found.name, found.path) == ('robot', str(package))
    assert package_above(str(package / 'launch' / 'robot.launch.py')) == found
    assert package_at(str(package / 'launch')) is None


def test_a_file_outside_any_package_has_none(tmp_path: Path) -> None:
    assert package_above(str(tmp_path / 'a.launch.py')) is None


def test_the_workspace_is_what_was_handed_in(package: Path, tmp_path: Path) -> None:
    """Never a folder above it that is called src: other students, keys and solutions lie there."""
    assert Submission(str(package)).workspaces == [str(package)]
    assert Submission(str(package), str(tmp_path / 'ws')).workspaces == [str(tmp_path / 'ws')]


def test_a_link_is_refused(package: Path, tmp_path: Path) -> None:
    (tmp_path / 'link').symlink_to(package)
    launch = package / 'launch' / 'robot.launch.py'
    (tmp_path / 'robot.launch.py').symlink_to(launch)
    for path in (tmp_path / 'link', tmp_path / 'robot.launch.py'):
        with pytest.raises(UnusableInput, match='is a link, and links are not followed'):
            Submission(str(path))
    launch.rename(tmp_path / 'elsewhere.launch.py')
    launch.symlink_to(tmp_path / 'elsewhere.launch.py')
    with pytest.raises(UnusableInput, match='is a link, and links are not followed'):
        Submission(str(package))


def test_without_src_the_package_is_its_own_workspace(package: Path, tmp_path: Path) -> None:
    alone = package.rename(tmp_path / 'alone')
    assert Submission(str(alone / 'launch' / 'robot.launch.py')).workspaces == [str(alone)]


def test_a_folder_stands_for_the_launch_file_named_after_the_package(package: Path) -> None:
    submission = Submission(str(package))
    assert submission.file == str(package / 'launch' / 'robot.launch.py')
    assert (submission.exercise, submission.folder) == ('robot', str(package))
    assert submission.shown_folder == f'{package}/'


def test_paths_are_shown_as_they_were_given(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(package.parent)
    assert Submission('my_copy').shown_folder == 'my_copy/'
    assert Submission('my_copy/launch/robot.launch.py').shown_folder == 'my_copy/'
    monkeypatch.chdir(package / 'launch')
    assert Submission('robot.launch.py').shown_folder == '../'


def test_gaps_of_all_files_come_in_the_order_of_their_numbers(package: Path) -> None:
    gaps = Submission(str(package)).source.gaps
    assert [(Path(gap.file).name, gap.line, gap.text) for gap in gaps] == [
        ('a.yaml', 1, '# TODO 1: a'),
        ('robot.launch.py', 1, '# TODO 2: b'),
    ]


def test_an_edit_of_any_file_changes_seed_and_hash_and_generated_files_do_not(package: Path) -> None:
    before = Submission(str(package))
    (package / 'build').mkdir()
    (package / 'build' / 'x.py').write_text('generated')
    assert Submission(str(package)).sha256 == before.sha256
    (package / 'config' / 'a.yaml').write_text('edited')
    after = Submission(str(package))
    assert (after.seed != before.seed, after.sha256 != before.sha256) == (True, True)


def test_a_package_without_its_launch_file_names_what_there_is(package: Path) -> None:
    (package / 'launch' / 'robot.launch.py').rename(package / 'launch' / 'start.launch.py')
    with pytest.raises(UnusableInput) as error:
        Submission(str(package))
    assert error.value.message == 'the package robot has no file launch/robot.launch.py'
    assert error.value.help is not None
    assert error.value.help.endswith('launch/start.launch.py')
