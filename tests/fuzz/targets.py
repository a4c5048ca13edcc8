"""What reads something from outside: each target feeds it one changed input, and a traceback of ours is an error.

`python -m tests.fuzz.targets NAME COUNT [FIRST]` tries many inputs, and prints each kind of traceback once with its number.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import random
import re
import shlex
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from traceback import extract_tb
from typing import Any

import yaml
from edugrade.rubric import RubricMistake

import edulaunch
from edulaunch.errors import EdulaunchError
from tests.fuzz.changes import NASTY, changed, changed_bytes, changed_data

ROOT = Path(__file__).resolve().parents[2]
OURS = (os.path.join(str(ROOT), 'edulaunch', ''), os.path.join(str(ROOT), 'grader', ''))
STUDENTS = os.path.join(str(ROOT), 'edulaunch', 'ros', 'share', '')
FRAME = re.compile(r'File "([^"]+)", line (\d+), in (\S+)')
Target = Callable[[Path, random.Random], object]
TARGETS: dict[str, Target] = {}


MOSTLY = 0.8
"""The share of the inputs whose syntax is right, so that they get beyond the parser."""


def changed_yaml(text: str, chance: random.Random) -> bytes:
    """A YAML document with other data, or with mistakes in its syntax."""
    if chance.random() > MOSTLY:
        return changed_bytes(text.encode(), chance)
    return yaml.safe_dump(changed_data(yaml.safe_load(text), chance), sort_keys=False, allow_unicode=True).encode()


def changed_json_lines(data: bytes, chance: random.Random) -> bytes:
    """A file of JSON lines with other data in one or two of them, or with mistakes in its syntax."""
    if chance.random() > MOSTLY:
        return changed_bytes(data, chance)
    lines: list[Any] = [json.loads(line) for line in data.splitlines()]
    for _ in range(chance.randint(1, 2)):
        place = chance.randrange(len(lines))
        lines[place] = changed_data(lines[place], chance)
    return b''.join(json.dumps(line, default=str, skipkeys=True).encode() + b'\n' for line in lines)


class Ours(Exception):
    """A traceback of ours; its text is the kind: the error, and the place."""


def target(function: Target) -> Target:
    TARGETS[function.__name__] = function
    return function


def printed_kind(text: str) -> str | None:
    """The kind of a traceback in an output that ends in a file of ours and shows nothing of the input's author."""
    for block in text.split('Traceback (most recent call last):')[1:]:
        frames = FRAME.findall(block)
        if frames and all(place.startswith(OURS) and not place.startswith(STUDENTS) for place, _, _ in frames):
            last = next((line for line in block.splitlines() if re.match(r'[\w.]+(Error|Exception|Interrupt)\b', line)), '?')
            return f'{last.partition(":")[0]} at {os.path.basename(frames[-1][0])}:{frames[-1][1]}'
    return None


def run_main(words: list[str]) -> str:
    """Run a command in this process; return what it printed."""
    from edulaunch.desk.cli.main import main

    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out), contextlib.suppress(SystemExit):
        main(words)
    kind = printed_kind(out.getvalue())
    if kind is not None:
        raise Ours(kind)
    return out.getvalue()


@target
def rubric(folder: Path, chance: random.Random) -> None:
    from edugrade.rubrics.catalogue import load_rubric
    from edugrade.rubrics.yaml_lint import points_for_defaults, points_for_names

    file = folder / 'rubric.yaml'
    file.write_bytes(changed_yaml(chance.choice(RUBRICS), chance))
    load_rubric(str(file))
    for lint in (points_for_names, points_for_defaults):
        list(lint(str(file)))


@target
def bag(folder: Path, chance: random.Random) -> None:
    place = folder / 'bag'
    if not place.exists():
        _machine(folder).type(f'ros2 bag record -o {place} /chatter', 3.0)
        (place / 'good.yaml').write_bytes((place / 'metadata.yaml').read_bytes())
    (place / 'metadata.yaml').write_bytes(changed_yaml((place / 'good.yaml').read_text(), chance))
    _machine(folder).type(f'ros2 bag info {place}')
    if chance.random() < 0.2:
        _machine(folder).type(f'ros2 bag play {place}', 0.3)


@target
def package(folder: Path, chance: random.Random) -> None:
    name, text = chance.choice(list(PACKAGE.items()))
    place = folder / 'ws' / 'src' / 'mine'
    for other, good in PACKAGE.items():
        (place / other).parent.mkdir(parents=True, exist_ok=True)
        (place / other).write_text(good)
    (place / name).write_bytes(changed_yaml(text, chance) if name.endswith('.yaml') else changed_bytes(text.encode(), chance))
    run_main(['explain', str(folder / 'ws')])
    run_main(
        ['explain', 'mine', 'go.launch.py', '--workspace', str(folder / 'ws')]
        if chance.random() < 0.3
        else ['doctor', str(folder / 'ws')]
    )


@target
def launch(folder: Path, chance: random.Random) -> None:
    ending, text = chance.choice(list(LAUNCHES.items()))
    file = folder / f'fuzzed.launch.{ending}'
    file.write_bytes(changed_yaml(text, chance) if ending == 'yaml' else changed_bytes(text.encode(), chance))
    run_main(['launch', str(file), '--for', '0.3', '--fast', *(['--quiet'] if chance.random() < 0.5 else [])])
    if chance.random() < 0.2:
        run_main([chance.choice(['explain', 'plan']), str(file)])


@target
def recording(folder: Path, chance: random.Random) -> None:
    good = folder / 'good.rec'
    if not good.exists():
        edulaunch.run(_launch(folder, "cmd=['ros2', 'topic', 'echo', '/chatter']"), duration_s=2.0).save(good)
    file = folder / 'changed.rec'
    file.write_bytes(changed_json_lines(good.read_bytes(), chance))
    loaded = edulaunch.Recording.load(file)
    (
        loaded.digest(),
        loaded.advice,
        loaded.facts,
        loaded.mismatches,
        loaded.not_repeatable,
        list(map(loaded.messages, loaded.topics)),
    )
    run_main(['recording', 'show', str(file)])


@target
def command(folder: Path, chance: random.Random) -> None:
    words = shlex.split(chance.choice(COMMANDS))
    for _ in range(chance.randint(1, 2)):
        place = chance.randint(1, len(words) - 1)
        if chance.random() < MOSTLY and place > 1 and not words[place].startswith('-'):
            words[place] = changed(words[place], chance) if chance.random() < 0.5 else chance.choice(WORDS)
        else:
            words[place : place + chance.randint(0, 1)] = [chance.choice(WORDS)]
    if words[0] == 'ros2':
        _machine(folder).type(words, 0.3)
    else:
        run_main([word for word in words[1:] if '\0' not in word])


class Machine:
    """A machine with a turtlesim and a talker, which is replaced from time to time."""

    MOST = 60

    def __init__(self) -> None:
        from edulaunch.runtime.session import Session

        self.session = Session(console=lambda *_: None)
        self.typed = 0
        self.start(['ros2', 'run', 'turtlesim', 'turtlesim_node'], [])
        self.start(['ros2', 'run', 'demo_nodes_py', 'talker'], [])
        self.session.run(1.0)

    def start(self, words: list[str], printed: list[str]) -> Any:
        from edulaunch.engine.processes.spec import ProcessSpec

        spec = ProcessSpec(argv=tuple(words), name=f'typed-{self.typed}')
        return self.session.host.start(spec, lambda stream, text: printed.append(text), lambda code: None)

    def type(self, line: str | list[str], seconds: float = 0.2) -> None:
        """Type a command, end it, and look at what it printed."""
        self.typed += 1
        printed: list[str] = []
        process = self.start(shlex.split(line) if isinstance(line, str) else line, printed)
        self.session.run(seconds)
        if process.returncode is None:
            process.send_signal(2)
            self.session.run(0.5)
        kind = printed_kind(''.join(printed))
        if kind is not None:
            raise Ours(kind)


_machines: list[Machine] = []


def _machine(folder: Path) -> Machine:
    os.chdir(folder)
    if not _machines or _machines[0].typed >= Machine.MOST:
        for machine in _machines:
            machine.session.close()
        _machines[:] = [Machine()]
    return _machines[0]


def _launch(folder: Path, what: str) -> Path:
    file = folder / 'makes.launch.py'
    file.write_text(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\nfrom launch_ros.actions import Node\n'
        "def generate_launch_description():\n    return LaunchDescription([Node(package='demo_nodes_py', executable='talker'), "
        f'ExecuteProcess({what})])\n'
    )
    return file


def kind_of(error: BaseException) -> str:
    """The kind of an error that left a target: its class and the innermost place."""
    if isinstance(error, Ours):
        return str(error)
    frame = extract_tb(error.__traceback__)[-1]
    return f'{type(error).__name__} at {os.path.basename(frame.filename)}:{frame.lineno}'


def attempt(name: str, number: int, folder: Path) -> str | None:
    """Try one input; return the kind of traceback, or None for an answer or a sentence."""
    before = os.getcwd()
    try:
        TARGETS[name](folder, random.Random(f'{name} {number}'))
    except (EdulaunchError, RubricMistake):
        return None
    except Exception as error:
        return kind_of(error)
    finally:
        os.chdir(before)
    return None


def main(name: str, count: int, first: int = 0) -> None:
    """Try inputs, and print each kind once."""
    found: dict[str, int] = {}
    begun_s = time.process_time()
    with tempfile.TemporaryDirectory() as folder:
        for number in range(first, first + count):
            kind = attempt(name, number, Path(folder))
            if kind is not None and kind not in found:
                found[kind] = number
                print(f'{name} {number}: {kind}', flush=True)
    print(f'{name}: {count} inputs, {len(found)} kinds, {time.process_time() - begun_s:.0f} s of processor time', flush=True)


RUBRICS = (
    (ROOT / 'edulaunch' / 'course' / 'starter' / 'rubrics' / 'spin.yaml').read_text(),
    'title: A\nruns: [{name: one, duration: 2.0}, {name: two, arguments: {who: b}}]\nchecks:\n'
    '  - {name: command, points: 2, command: {words: ros2 bag record}}\n'
    '  - {hears: {node: /a, topic: /b}, points: 1, needs: [command]}\n'
    '  - {nodes: {are: [/a], package: x}, points: 1}\n  - {starts: {node: /a, at: 0}, hint: no}\n',
)
PACKAGE = {
    'setup.py': 'from setuptools import find_packages, setup\nimport os\nfrom glob import glob\npackage_name = "mine"\nsetup(\n'
    '    name=package_name,\n    version="0.0.1",\n    packages=find_packages(exclude=["test"]),\n    data_files=[\n'
    '        ("share/ament_index/resource_index/packages", ["resource/" + package_name]),\n'
    '        (os.path.join("share", package_name), ["package.xml"]),\n'
    '        (os.path.join("share", package_name, "launch"), glob("launch/*.launch.py")),\n    ],\n'
    '    entry_points={"console_scripts": ["go = mine.go:main"]},\n)\n',
    'package.xml': '<?xml version="1.0"?>\n<package format="3">\n  <name>mine</name>\n  <version>0.0.1</version>\n  <description>x</description>\n'
    '  <maintainer email="a@b.c">a</maintainer>\n  <license>MIT</license>\n  <exec_depend condition="$ROS_VERSION == 2">rclpy</exec_depend>\n'
    '  <export>\n    <build_type>ament_python</build_type>\n  </export>\n</package>\n',
    'setup.cfg': '[develop]\nscript_dir=$base/lib/mine\n[install]\ninstall_scripts=$base/lib/mine\n',
    'CMakeLists.txt': 'cmake_minimum_required(VERSION 3.8)\nproject(mine)\nfind_package(ament_cmake REQUIRED)\n'
    'find_package(rosidl_default_generators REQUIRED)\nset(files "msg/A.msg" "srv/B.srv")\nrosidl_generate_interfaces(${PROJECT_NAME} ${files})\n'
    'install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\ninstall(PROGRAMS scripts/go.py DESTINATION lib/${PROJECT_NAME})\nament_package()\n',
    'msg/A.msg': '# text\nint32[<=3] numbers [1, 2]\nstring<=5 name "a"\nuint8 MOST=200\nstd_msgs/Header[] headers\n',
    'launch/go.launch.py': 'from launch import LaunchDescription\nfrom launch_ros.actions import Node\ndef generate_launch_description():\n'
    '    return LaunchDescription([Node(package="mine", executable="go", parameters=["config/go.yaml"])])\n',
    'config/go.yaml': '/**:\n  ros__parameters:\n    speed: 1.5\n    names: [a, b]\n',
    'mine/__init__.py': '',
    'mine/go.py': 'import rclpy\nfrom rclpy.node import Node\ndef main():\n    rclpy.init()\n    node = Node("go")\n    rclpy.spin(node)\n',
    'resource/mine': '',
}
LAUNCHES = {
    'py': 'from launch import LaunchDescription\nfrom launch.actions import DeclareLaunchArgument, ExecuteProcess, TimerAction\n'
    'from launch.substitutions import LaunchConfiguration\nfrom launch_ros.actions import Node\n\ndef generate_launch_description():\n'
    '    return LaunchDescription([\n        DeclareLaunchArgument("who", default_value="me", choices=["me", "you"]),\n'
    '        Node(package="turtlesim", executable="turtlesim_node", name=LaunchConfiguration("who"), parameters=[{"background_r": 3}],\n'
    '             remappings=[("a", "b")]),\n        TimerAction(period=0.1, actions=[ExecuteProcess(cmd=["ros2", "topic", "list"])]),\n    ])\n',
    'xml': '<launch>\n  <arg name="who" default="me"/>\n  <group ns="a" if="$(eval \'1 == 1\')">\n    <push-ros-namespace namespace="b"/>\n'
    '    <node pkg="turtlesim" exec="turtlesim_node" name="$(var who)">\n      <param name="background_r" value="3"/>\n'
    '      <remap from="a" to="b"/>\n    </node>\n  </group>\n  <timer period="0.1"><log message="$(env HOME) $(dirname)"/></timer>\n'
    '  <include file="$(find-pkg-share turtlesim)/launch/multisim.launch.py"/>\n</launch>\n',
    'yaml': 'launch:\n- arg: {name: who, default: me}\n- group:\n  - push_ros_namespace: {namespace: b}\n  - node:\n      pkg: turtlesim\n'
    '      exec: turtlesim_node\n      name: $(var who)\n      param:\n      - {name: background_r, value: 3}\n      remap:\n      - {from: a, to: b}\n'
    '- executable: {cmd: ros2 topic list, output: screen}\n- timer: {period: 0.1, children: [{log: {message: hi}}]}\n',
}
WORDS = [
    *NASTY,
    '\udce9',
    '/turtlesim',
    '/rosout',
    '/turtle1',
    'turtlesim/msg/Pose',
    'std_srvs/srv/Empty',
    '{x: 1}',
    '{x: [',
    '{a: b}',
    '3',
    '.',
]
COMMANDS = (
    'ros2 topic pub --once /turtle1/cmd_vel geometry_msgs/msg/Twist "{linear: {x: 2.0}, angular: {z: 1.8}}"',
    'ros2 topic echo /turtle1/pose --field x --csv',
    'ros2 topic list -t --include-hidden-topics',
    'ros2 topic hz /turtle1/pose --window 5',
    'ros2 service call /spawn turtlesim/srv/Spawn "{x: 2, y: 2, theta: 0.2, name: bob}"',
    'ros2 param set /turtlesim background_r 5',
    'ros2 param load /turtlesim params.yaml',
    'ros2 param dump /turtlesim',
    'ros2 node info /turtlesim --include-hidden',
    'ros2 interface show geometry_msgs/msg/Twist --no-comments',
    'ros2 action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute "{theta: 1.57}" --feedback',
    'ros2 run turtlesim turtlesim_node --ros-args -r __node:=other -p background_r:=5 --log-level debug',
    'ros2 launch turtlesim multisim.launch.py --show-args',
    'ros2 bag record -o out /turtle1/pose --max-bag-size 5',
    'ros2 pkg create mine --build-type ament_python --dependencies rclpy',
    'ros2 lifecycle set /turtlesim configure',
    'ros2 component load /c demo_nodes_cpp demo_nodes_cpp::Talker',
    'ros2 doctor --report',
    'edulaunch explain turtlesim multisim.launch.py who:=me',
    'edulaunch launch turtlesim multisim.launch.py --for 0.1 --fast --seed 3 --quiet',
    'edulaunch recording show good.rec --json',
    'edulaunch plan turtlesim multisim.launch.py --json',
    'edulaunch doctor . --json',
    'edulaunch advice list',
)


if __name__ == '__main__':
    main(sys.argv[1], int(sys.argv[2]), int((sys.argv[3:] or ['0'])[0]))
