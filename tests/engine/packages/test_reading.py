"""Which folders of a workspace are packages, and what their package.xml says."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from edulaunch.engine.packages.reading import Manifest, PackageWarning, find_packages, read_manifest


def write(folder: Path, *files: str, text: str = '') -> Path:
    for name in files:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return folder


def found(folder: Path, most: int = 5000) -> list[str]:
    warnings: list[PackageWarning] = []
    names = [os.path.relpath(path, folder) for path in find_packages(str(folder), warnings, most)]
    assert warnings == []
    return names


def read(folder: Path, text: str, *files: str) -> tuple[Manifest | None, list[PackageWarning]]:
    write(folder, *files)
    write(folder, 'package.xml', text=text)
    warnings: list[PackageWarning] = []
    return read_manifest(str(folder), warnings), warnings


@pytest.mark.parametrize(
    ('inside', 'files', 'build_type'),
    [
        ('<export><build_type> ament_python </build_type></export>', ('CMakeLists.txt',), 'ament_python'),
        ('', ('setup.py',), 'ament_python'),
        ('', ('CMakeLists.txt',), 'ament_cmake'),
        ('', ('setup.py', 'CMakeLists.txt'), 'ament_cmake'),
        ('', (), 'ament_cmake'),
        ('<buildtool_depend>catkin</buildtool_depend>', (), 'catkin'),
        ('<buildtool_depend>catkin</buildtool_depend><buildtool_depend>ament_cmake</buildtool_depend>', (), 'ament_cmake'),
    ],
)
def test_the_build_type_is_named_or_follows_from_the_files(
    tmp_path: Path, inside: str, files: tuple[str, ...], build_type: str
) -> None:
    manifest, warnings = read(tmp_path, f'<package><name> robot </name>{inside}</package>', *files)
    assert (manifest, warnings) == (Manifest('robot', build_type, str(tmp_path)), [])


@pytest.mark.parametrize(
    ('text', 'line', 'words'),
    [
        ('<package>\n<name>robot</nam>\n</package>', 2, 'this is not well-formed XML'),
        ('<package/>', 0, "has no usable <name> inside <package> (found '')"),
        ('<package><name>my robot</name></package>', 0, "(found 'my robot')"),
        ('<package><name>-robot</name></package>', 0, "(found '-robot')"),
        ('<robot><name>robot</name></robot>', 0, 'has no usable <name> inside <package>'),
    ],
)
@pytest.mark.parametrize('file', ['setup.py', 'CMakeLists.txt', 'README.md'])
def test_a_manifest_that_cannot_be_used_is_named_with_its_line_and_what_a_build_does(
    tmp_path: Path, text: str, line: int, words: str, file: str
) -> None:
    manifest, (warning,) = read(tmp_path, text, file)
    assert manifest is None and words in warning.sentence
    assert (warning.file, warning.line) == (str(tmp_path / 'package.xml'), line)
    kinds = {kind for kind in ('Python', 'CMake') if f'{kind} package' in warning.sentence or f'a {kind}' in warning.sentence}
    assert kinds == {'setup.py': {'Python'}, 'CMakeLists.txt': {'CMake'}}.get(file, set())


def test_a_manifest_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    warnings: list[PackageWarning] = []
    assert read_manifest(str(tmp_path), warnings) is None
    assert [str(warning) for warning in warnings] == [f'{tmp_path}/package.xml: cannot be read (No such file or directory)']


def test_packages_are_found_by_depth_and_name_and_nothing_inside_of_them(tmp_path: Path) -> None:
    write(tmp_path, *(f'{name}/package.xml' for name in ('src/b', 'src/a', 'src/a/inner', 'z', 'src/deep/er/c')))
    assert found(tmp_path) == ['z', 'src/a', 'src/b', 'src/deep/er/c']
    write(tmp_path, 'package.xml')
    assert found(tmp_path) == ['.']


@pytest.mark.parametrize(
    'folder', ['build', 'install', 'log', '__pycache__', 'node_modules', '.hidden', 'COLCON', 'AMENT', 'CATKIN', 'venv']
)
def test_folders_that_a_build_leaves_out(tmp_path: Path, folder: str) -> None:
    write(tmp_path, 'src/robot/package.xml', f'{folder}/robot/package.xml')
    if folder == 'venv':
        write(tmp_path, 'venv/pyvenv.cfg')
    elif folder.isupper():
        write(tmp_path, f'{folder}/{folder}_IGNORE')
    assert found(tmp_path) == ['src/robot']


def test_a_link_is_followed_and_no_folder_visited_twice(tmp_path: Path) -> None:
    write(tmp_path, 'elsewhere/robot/package.xml')
    workspace = tmp_path / 'ws'
    workspace.mkdir()
    (workspace / 'linked').symlink_to(tmp_path / 'elsewhere')
    (workspace / 'round').symlink_to(workspace)
    assert found(workspace) == ['linked/robot']


def test_a_folder_that_is_too_large_is_searched_in_part_and_named(tmp_path: Path) -> None:
    write(tmp_path, *(f'{number}/file' for number in range(9)))
    assert found(tmp_path, most=10) == []
    warnings: list[PackageWarning] = []
    find_packages(str(tmp_path), warnings, 5)
    assert len(warnings) == 1 and '5' in warnings[0].sentence
