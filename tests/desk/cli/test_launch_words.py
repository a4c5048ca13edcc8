"""`edulaunch launch`: what it makes of its words, and what it says when nothing can be launched of them."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch
from edulaunch.desk.cli.launch import split_words
from edulaunch.desk.cli.main import main
from edulaunch.errors import UnusableInput
from edulaunch.runtime.launching import find_launch_file

from .conftest import describe


def test_an_argument_without_its_sign_is_malformed(run) -> None:
    code, out, err = run(describe(), 'mode=fast')
    assert (code, out) == (2, '')
    assert err == ("error: malformed launch argument 'mode=fast', expected format '<name>:=<value>'\n  help: write mode:=fast\n")


def test_files_that_are_none(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'robot.launch.py').write_text(describe())
    for word, said in (
        ('rbot.launch.py', "error: launch file 'rbot.launch.py' does not exist.\n  help: did you mean 'robot.launch.py'?\n"),
        ('.', "error: '.' is a folder, not a launch file.\n  help: name a file in it: robot.launch.py\n"),
        ('no/such.launch.py', "error: launch file 'no/such.launch.py' does not exist.\n  help: check the path: the folder"),
    ):
        assert main(['launch', word]) == 2
        assert capsys.readouterr().err.startswith(said)


@pytest.mark.parametrize(
    ('words', 'said'),
    [
        (['turtlesm', 'multisim.launch.py'], "Package 'turtlesm' not found: \"package 'turtlesm' not found, searching:"),
        (
            ['turtlesim', 'multisim.lunch.py'],
            "file 'multisim.lunch.py' was not found in the share directory of package 'turtlesim' which is at",
        ),
        (['turtlesim'], 'the launch file of the package turtlesim is not named'),
    ],
)
def test_packages_and_files_that_are_none(words: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['launch', *words]) == 2
    err = capsys.readouterr().err
    assert said in err and '\n  help: ' in err


@pytest.mark.parametrize(
    ('first', 'rest', 'expected'),
    [
        (__file__, ['a:=1', 'a:=2', 'b:=x:=y'], (__file__, None, {'a': '2', 'b': 'x:=y'})),
        ('pkg', ['file.py', 'a:=1'], ('pkg', 'file.py', {'a': '1'})),
        ('pkg', [], ('pkg', None, {})),
    ],
)
def test_words_are_split_as_ros2_launch_does(first: str, rest: list[str], expected: object) -> None:
    assert split_words(first, rest) == expected


@pytest.mark.parametrize('word', ['novalue', ':=x', 'name:='])
def test_malformed_words(word: str) -> None:
    with pytest.raises(UnusableInput, match='malformed launch argument'):
        split_words(__file__, [word])


def test_an_option_with_one_hyphen_too_few_is_named(run, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main(['launch', 'turtlesim', 'multisim.launch.py', '-for', '2'])
    assert caught.value.code == 2
    assert capsys.readouterr().err.endswith("unrecognized arguments: -for 2\n  help: did you mean '--for'?\n")


def test_a_path_in_two_words_is_told_as_one(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'my.launch.py').write_text(describe())
    assert main(['launch', str(tmp_path), 'my.launch.py']) == 2
    assert f'help: write the path as one word: {tmp_path}/my.launch.py\n' in capsys.readouterr().err


def test_a_package_without_a_file_name_lists_its_launch_files(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['launch', 'turtlesim']) == 2
    assert capsys.readouterr().err.endswith('help: name a launch file of turtlesim: multisim.launch.py\n')


def test_a_launch_file_that_was_deleted_meanwhile(tmp_path: Path) -> None:
    from edulaunch.runtime.session import Session

    package = tmp_path / 'robo'
    (package / 'launch').mkdir(parents=True)
    (package / 'launch' / 'go.launch.py').write_text(describe())
    (package / 'package.xml').write_text('<package format="3"><name>robo</name></package>')
    (package / 'CMakeLists.txt').write_text(
        'project(robo)\nfind_package(ament_cmake)\ninstall(DIRECTORY launch DESTINATION share/robo)\nament_package()\n'
    )
    with Session(workspaces=[tmp_path]) as session:
        session.index.share('robo')
        (package / 'launch' / 'go.launch.py').unlink()
        with pytest.raises(UnusableInput, match='does not exist|was not found'):
            session.launch('robo', 'go.launch.py')


@pytest.mark.parametrize(
    ('words', 'near'), [('lanch x', 'launch'), ('view --tab grph', 'graph'), ('course lst', 'list'), ('machine stats', 'status')]
)
def test_a_misspelt_word_is_told_with_the_nearest_that_there_is(
    words: str, near: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(words.split())
    assert ended.value.code == 2 and capsys.readouterr().err.endswith(f"  help: did you mean '{near}'?\n")


def test_only_ros2_launch_says_what_ros_says_without_the_name_of_a_file() -> None:
    with edulaunch.Session() as session:
        with pytest.raises(UnusableInput, match="file 'None' was not found in the share directory of package 'turtlesim'"):
            find_launch_file(session.index, 'turtlesim', None, as_ros=True)
        with pytest.raises(UnusableInput, match='the launch file of the package turtlesim is not named') as ours:
            find_launch_file(session.index, 'turtlesim', None)
    assert ours.value.help == 'name a launch file of turtlesim: multisim.launch.py'
