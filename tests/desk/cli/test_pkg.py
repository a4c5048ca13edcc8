"""`edulaunch pkg`."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.desk.cli.main import main


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_create_takes_the_words_of_ros2_pkg_create(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['pkg', 'create', '--build-type', 'ament_python', '--license', 'Apache-2.0', '--', 'learning_tf2_py']) == 0
    assert (
        main(
            [
                'pkg',
                'create',
                'robo',
                '--build-type',
                'ament_python',
                '--dependencies',
                'rclpy',
                'std_msgs',
                '--maintainer-name',
                'Ada',
                '--maintainer-email',
                'ada@example.org',
                '--description',
                'drives',
                '--node-name',
                'go',
            ]
        )
        == 0
    )
    said = capsys.readouterr().out
    assert "maintainer: ['Ada <ada@example.org>']" in said and 'creating folder ./robo\n' in said
    text = (here / 'robo/package.xml').read_text()
    assert '<depend>rclpy</depend>\n  <depend>std_msgs</depend>' in text and '<description>drives</description>' in text
    assert (here / 'learning_tf2_py/LICENSE').is_file()


def test_an_existing_folder_aborts(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (here / 'robo').mkdir()
    assert main(['pkg', 'create', 'robo']) == 1
    assert capsys.readouterr().err.startswith('\nAborted!\nThe directory already exists: ./robo\n')


def test_check_prints_findings_and_counts_them(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(['pkg', 'create', 'robo', '--build-type', 'ament_python'])
    assert main(['pkg', 'check']) == 0
    (here / 'robo/launch').mkdir()
    (here / 'robo/launch/go.launch.py').write_text('def generate_launch_description():\n    pass\n')
    capsys.readouterr()
    assert main(['pkg', 'check', '.']) == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith('robo/launch/go.launch.py: the build of robo does not install the launch file')
    assert lines[-1] == '1 package checked (robo): 1 finding'


def test_check_of_no_folder_is_unusable_input(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['pkg', 'check', 'nowhere']) == 2
    assert "'nowhere' is not a folder" in capsys.readouterr().err


def test_in_a_course_it_says_how_to_make_a_package_in_python(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = 'For a Python package, delete it and type: ros2 pkg create robo --build-type ament_python'
    assert main(['pkg', 'create', 'robo']) == 0
    assert words not in capsys.readouterr().err
    (here / 'exercises').mkdir()
    (here / 'exercises' / 'course.toml').write_text('')
    assert main(['pkg', 'create', 'robo', '--destination-directory', 'exercises']) == 0
    assert words in capsys.readouterr().err
    assert main(['pkg', 'create', 'robot', '--build-type', 'ament_python']) == 0
    assert words not in capsys.readouterr().err
