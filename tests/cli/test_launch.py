"""`edulaunch launch`: the console of `ros2 launch`, and what it says to bad input."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.cli.launch import split_words
from edulaunch.cli.main import main
from edulaunch.errors import UnusableInput

ROOT = Path(__file__).resolve().parents[2]
HEAD = 'from launch import LaunchDescription\nfrom launch.actions import *\nfrom launch_ros.actions import Node\n'


@pytest.fixture
def run(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    """Write a launch file, run it as the command does, and return (exit code, stdout, stderr) without the folder's path."""

    def run_command(text: str | bytes, *words: str, name: str = 'my.launch.py') -> tuple[int, str, str]:
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        code = main(['launch', str(path), '--fast', '--for', '3', *words])
        out, err = capsys.readouterr()
        return code, out.replace(str(tmp_path), '@'), err.replace(str(tmp_path), '@')

    return run_command


def describe(*entities: str) -> str:
    return f'{HEAD}def generate_launch_description():\n    return LaunchDescription([{", ".join(entities)}])\n'


def test_the_console_is_that_of_ros2_launch(run) -> None:
    code, out, err = run(describe("LogInfo(msg='hello')", "Node(package='demo_nodes_cpp', executable='talker', output='screen')"))
    lines = out.splitlines()
    assert lines[:3] == [
        '[INFO] [launch]: Default logging verbosity is set to INFO',
        '[INFO] [launch.user]: hello',
        '[INFO] [talker-1]: process started with pid [1002]',
    ]
    assert lines[3] == "[talker-1] [INFO] [1700000001.000000000] [talker]: Publishing: 'Hello World: 1'"
    assert '[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)' in lines
    assert lines[-1] == '[INFO] [talker-1]: process has finished cleanly [pid 1002]'
    assert (code, err) == (0, '')


@pytest.mark.parametrize(
    ('text', 'said', 'where', 'tried'),
    [
        ('x = 1\n', "does not contain the required function 'generate_launch_description()'", '', ''),
        (
            HEAD + 'def generate_launch_description():\n    LaunchDescription([])\n',
            "'NoneType' object has no attribute",
            '',
            'return',
        ),
        (
            HEAD + 'def generate_launch_description():\n    return [LogInfo(msg="x")]\n',
            "'list' object has no attribute",
            '',
            'LaunchDescription',
        ),
        (HEAD + 'def generate_launch_description(:\n', 'SyntaxError: invalid syntax', 'my.launch.py:4', ''),
        (
            HEAD + 'def generate_launch_description():\n    return 1 / 0\n',
            'ZeroDivisionError: division by zero',
            'my.launch.py:5',
            '',
        ),
        (
            describe("Node(package='turtlesm', executable='turtlesim_node')"),
            "package 'turtlesm' not found, searching:",
            'my.launch.py:5',
            'turtlesim',
        ),
        (
            describe("Node(package='turtlesim', executable='turtle')"),
            "executable 'turtle' not found on the libexec directory",
            'my.launch.py:5',
            'turtle',
        ),
        (describe("DeclareLaunchArgument('n', default_value=3)"), "'int' object is not iterable", 'my.launch.py:5', "'3'"),
        (describe("DeclareLaunchArgument('needed')"), "missing required argument 'needed'", '', ''),
    ],
)
def test_a_launch_file_that_cannot_work_is_explained(run, text: str, said: str, where: str, tried: str) -> None:
    code, out, err = run(text)
    assert said in out and where in out and tried in out
    assert code == 1 and 'Traceback' not in out + err


def test_a_node_that_dies_is_as_silent_as_in_ros_but_for_one_warning(run, tmp_path: Path) -> None:
    code, out, err = run(describe("Node(package='turtlesim', executable='turtlesim_node', parameters=[{'background_r': 'red'}])"))
    assert 'process has died [pid 1002, exit code -6' in out
    assert code == 0 and err.count('\n') == 2 and err.startswith('warning: turtlesim_node-1 died with exit code -6')


def test_how_a_command_ended_that_a_program_runs_is_that_programs_business(run, tmp_path: Path) -> None:
    script = tmp_path / 'runs.py'
    script.write_text("import subprocess, time\ntime.sleep(1)\nsubprocess.run(['ros2', 'nonsense'], capture_output=True)\n")
    code, out, err = run(describe(f"ExecuteProcess(cmd=['python3', '{script}'])"))
    assert (code, err) == (0, '') and 'finished cleanly' in out


def test_a_misspelt_argument_is_accepted_with_one_warning(run) -> None:
    code, out, err = run(describe("DeclareLaunchArgument('radius', default_value='1')"), 'raduis:=2')
    assert (code, err) == (
        0,
        "warning: no launch file declares the argument 'raduis', so giving it changed nothing\n"
        "  help: write 'radius:=' instead of 'raduis:='\n",
    )


def test_an_argument_without_its_sign_is_malformed(run) -> None:
    code, out, err = run(describe(), 'mode=fast')
    assert (code, out) == (2, '')
    assert err == ("error: malformed launch argument 'mode=fast', expected format '<name>:=<value>'\n  help: write mode:=fast\n")


@pytest.mark.parametrize(
    ('text', 'said'),
    [
        ('robot: [1, 2\n', "Couldn't parse params file"),
        ('robot:\n  radius: 1\n', "Couldn't parse params file"),
        ('just text\n', "Couldn't parse params file"),
    ],
)
def test_a_parameter_file_that_cannot_be_read_is_explained(run, tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / 'p.yaml').write_text(text)
    code, out, err = run(
        describe(f"Node(package='demo_nodes_cpp', executable='talker', parameters=[{str(tmp_path / 'p.yaml')!r}])")
    )
    assert said in out and '@/p.yaml' in out
    assert code == 0 and '[talker-1]   help: ' in out and not err


def test_files_that_are_none(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'robot.launch.py').write_text(describe())
    for word, said in (
        ('rbot.launch.py', "error: launch file 'rbot.launch.py' does not exist.\n  help: did you mean 'robot.launch.py'?\n"),
        ('.', "error: '.' is a directory, not a launch file.\n  help: name a file in it: robot.launch.py\n"),
        ('no/such.launch.py', "error: launch file 'no/such.launch.py' does not exist.\n  help: there is no folder"),
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
        (['turtlesim'], "file 'None' was not found in the share directory of package 'turtlesim'"),
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


@pytest.mark.processes
def test_ctrl_c_in_real_time_shuts_down_as_ros_does() -> None:
    """The whole command in a process of its own, interrupted by a real signal as soon as it talks."""
    command = [sys.executable, '-m', 'edulaunch', 'launch', 'demo_nodes_cpp', 'talker_listener_launch.py']
    with subprocess.Popen(
        command,
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**os.environ, 'PYTHONUNBUFFERED': '1'},
    ) as child:
        assert child.stdout is not None
        lines = []
        for line in child.stdout:
            lines.append(line.rstrip())
            if 'process started with pid' in line and len(lines) >= 3:
                child.send_signal(signal.SIGINT)
        assert child.wait(20) == 0
    assert '[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)' in lines
    assert sum('process has finished cleanly' in line for line in lines) == 2


def test_a_program_reads_its_keyboard_from_a_file(run, tmp_path: Path) -> None:
    (tmp_path / 'keys').write_text('Ada\n')
    (tmp_path / 'ask.py').write_text("print('hello', input('name? '))\n")
    ask = f"ExecuteProcess(cmd=['python3', {str(tmp_path / 'ask.py')!r}], name='ask', output='screen')"
    code, out, err = run(describe(ask), '--stdin', f'ask={tmp_path / "keys"}', '--stdin', f'nobody={tmp_path / "keys"}')
    assert '[ask-1] name? hello Ada' in out.splitlines()
    assert (code, err) == (0, 'warning: --stdin nobody: no program of that name was started\n')


def test_a_package_that_a_build_would_reject_is_a_warning(run, tmp_path: Path) -> None:
    (tmp_path / 'ws').mkdir()
    (tmp_path / 'ws' / 'package.xml').write_text('<package>')
    code, out, err = run(describe("Node(package='turtlesim', executable='turtlesim_node')"), '--workspace', str(tmp_path / 'ws'))
    assert code == 0 and err.startswith('warning: @/ws/package.xml') and err.count('\n') == 1


def test_output_comes_before_the_line_about_the_end(run, tmp_path: Path) -> None:
    (tmp_path / 'count.py').write_text('for i in range(3): print(i)\nraise SystemExit(3)\n')
    code, out, err = run(describe(f"ExecuteProcess(cmd=['python3', {str(tmp_path / 'count.py')!r}], output='screen')"))
    assert out.splitlines()[1:] == [
        '[INFO] [python3-1]: process started with pid [1002]',
        '[python3-1] 0',
        '[python3-1] 1',
        '[python3-1] 2',
        "[ERROR] [python3-1]: process has died [pid 1002, exit code 3, cmd 'python3 @/count.py'].",
    ]


def test_a_program_that_cannot_be_started_is_explained_without_our_frames(run) -> None:
    code, out, err = run(describe("ExecuteProcess(cmd=['echo hi'])"))
    assert out.splitlines()[1:4] == [
        '[ERROR] [echo hi-1]: exception occurred while executing process:',
        "FileNotFoundError: [Errno 2] No such file or directory: 'echo hi'",
        "  help: @/my.launch.py:5: there is no program 'echo hi' on the PATH; write each argument as an item of cmd of its own, or "
        'shell=True',
    ]


def test_a_callback_that_waits_for_ever_is_a_warning(run, tmp_path: Path) -> None:
    (tmp_path / 'wait.py').write_text(
        'import rclpy\nfrom std_srvs.srv import Empty\nrclpy.init()\nnode = rclpy.create_node("a")\n'
        'node.create_service(Empty, "clear", lambda request, response: response)\nclient = node.create_client(Empty, "clear")\n'
        'async def tick():\n    await client.call_async(Empty.Request())\nnode.create_timer(1.0, tick)\nrclpy.spin(node)\n'
    )
    code, out, err = run(describe(f"ExecuteProcess(cmd=['python3', {str(tmp_path / 'wait.py')!r}])"), '--for', '3')
    assert err.startswith('warning: tick() of /a waits for the answer of /clear with await, for ever (')
    assert 'wait.py:8, at 1.00 s)' in err and err.count('\n') == 2


def test_a_command_in_one_text_is_explained(run) -> None:
    code, out, err = run(describe("ExecuteProcess(cmd='zz -a')"))
    assert out.splitlines()[2:4] == [
        "FileNotFoundError: [Errno 2] No such file or directory: 'z'",
        '  help: @/my.launch.py:5: cmd is one text, of which each letter became a word: put it into a list, cmd=[[...]] with shell=True',
    ]


def test_an_argument_that_the_included_file_does_not_declare_is_a_warning(run, tmp_path: Path) -> None:
    (tmp_path / 'inner.launch.py').write_text(describe("DeclareLaunchArgument('speed', default_value='1')"))
    code, out, err = run(
        describe(f"IncludeLaunchDescription({str(tmp_path / 'inner.launch.py')!r}, launch_arguments={{'speeed': '3'}}.items())")
    )
    assert (code, err) == (
        0,
        "warning: inner.launch.py is given the argument 'speeed', which it does not declare, so nothing changed "
        "(@/my.launch.py:5)\n  help: write 'speed' instead of 'speeed'\n",
    )


def test_endpoints_that_cannot_talk_because_of_their_types_are_told(run, tmp_path: Path) -> None:
    script = tmp_path / 'hears.py'
    script.write_text(
        'import rclpy\nfrom geometry_msgs.msg import Pose\nrclpy.init()\nnode = rclpy.create_node("hears")\n'
        'node.create_subscription(Pose, "/turtle1/pose", print, 10)\nrclpy.spin(node)\n'
    )
    _, _, err = run(
        describe("Node(package='turtlesim', executable='turtlesim_node')", f"ExecuteProcess(cmd=['python3', '{script}'])")
    )
    assert err == (
        'warning: /turtlesim publishes turtlesim/msg/Pose on /turtle1/pose, but /hears expects geometry_msgs/msg/Pose: '
        'they do not hear each other (@/my.launch.py:5, at 0.00 s)\n  help: use one message type on both sides, or two topics\n'
    )


def test_a_robot_that_hears_both_types_is_not_warned_of(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['launch', str(ROOT / 'solutions' / 'circle.launch.py'), '--fast', '--for', '2']) == 0
    assert capsys.readouterr().err == ''


def test_a_command_that_ctrl_c_ended_did_not_die(run) -> None:
    words = ['ros2', 'topic', 'pub', '/chatter', 'std_msgs/msg/String', 'data: hello']
    _, _, err = run(describe(f'ExecuteProcess(cmd={words})'))
    assert err == ''
    _, _, err = run(describe(f'ExecuteProcess(cmd={words[:3]})'))
    assert err == (
        'warning: ros2-1 died with exit code 2 (@/my.launch.py:5, at 0.00 s)\n'
        '  help: look at what it printed last: ros2 topic pub: error: the following arguments are required: '
        'topic_name, message_type\n'
    )


def test_the_heading_of_the_arguments_comes_before_what_an_included_file_says(run, tmp_path: Path) -> None:
    inner = tmp_path / 'inner.launch.py'
    inner.write_text(f'print("inner is read")\n{describe()}')
    _, out, _ = run(describe("DeclareLaunchArgument('speed')", f"IncludeLaunchDescription('{inner}')"), '-s')
    assert out.splitlines()[:4] == ["Arguments (pass arguments as '<name>:=<value>'):", 'inner is read', '', "    'speed':"]


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
    from edulaunch.session import Session

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


def test_the_run_can_be_looked_at_afterwards(run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    _, _, err = run(describe("Node(package='turtlesim', executable='turtlesim_node')"), '--view')
    assert err == 'view: my.html\n'
    assert (tmp_path / 'my.html').read_text().startswith('<!DOCTYPE html>')
