"""Whatever a launch file or a parameter file holds: there is a plan, or one of our errors."""

from __future__ import annotations

import io
import re
import tempfile
import tokenize
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edulaunch.advice.plan import rehearse
from edulaunch.runtime.session import index_for

FILE = """
import os
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, GroupAction, OpaqueFunction, RegisterEventHandler, TimerAction
from launch.conditions import IfCondition
from launch.event_handlers import OnProcessExit
from launch.substitutions import LaunchConfiguration, PythonExpression, TextSubstitution
from launch_ros.actions import Node, PushRosNamespace, SetParameter

def later(context, *args, **kwargs):
    return [Node(package='turtlesim', executable='turtlesim_node', name=LaunchConfiguration('who').perform(context))]

def generate_launch_description():
    first = Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[{'background_r': 3, 'holonomic': True}],
                 remappings=[('a', 'b')], condition=IfCondition(LaunchConfiguration('gui')), respawn_delay=2.0)
    return LaunchDescription([
        DeclareLaunchArgument('who', default_value='me', choices=['me', 'you']),
        DeclareLaunchArgument('gui', default_value=TextSubstitution(text='true')),
        SetParameter('use_sim_time', value=[1, 2]),
        GroupAction([PushRosNamespace('ns'), first], scoped=True),
        TimerAction(period=1.5, actions=[OpaqueFunction(function=later)]),
        RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[ExecuteProcess(cmd=['ls', os.sep], shell=True)])),
        ExecuteProcess(cmd=['echo', PythonExpression(["'", LaunchConfiguration('who'), "' == 'me'"])], additional_env={'A': 'b'}),
    ])
"""
TOKENS = [
    token.string
    for token in tokenize.generate_tokens(io.StringIO(FILE).readline)
    if token.type in (tokenize.NAME, tokenize.STRING, tokenize.OP, tokenize.NUMBER)
]
WORDS = st.one_of(
    st.sampled_from(sorted(set(TOKENS))),
    st.sampled_from(
        [
            'None',
            '3',
            '-1.5',
            '[]',
            '{}',
            'lambda: 0',
            'object()',
            "'$(var x)'",
            "b'x'",
            '(',
            ']',
            ',',
            '...',
            'nan',
            "'\\0'",
            'print',
            '*',
            'len',
        ]
    ),
)
INDEX = index_for([])
ADDRESS = re.compile('0x[0-9a-f]{4,}')


@pytest.fixture(scope='module')
def folder() -> Iterator[Path]:
    with tempfile.TemporaryDirectory() as path:
        yield Path(path)


def planned(path: Path) -> dict[str, Any]:
    plan = rehearse(path, {}, INDEX, {'PATH': '/usr/bin:/bin'}).plan
    error = plan['error']
    if error is not None:
        assert error['text'] and 'Traceback' not in error['text'] and not ADDRESS.search(error['text'])
        assert error['origin'] is None or '/edulaunch/' not in error['origin']
    return plan


@st.composite
def changed_files(draw: st.DrawFn) -> str:
    """The file with one to three of its words replaced, left out or doubled."""
    text = FILE
    for _ in range(draw(st.integers(1, 3))):
        places = [match for match in re.finditer(r"'[^'\n]*'|\w+|[^\w\s]", text) if match.start() > FILE.index('def later')]
        place = draw(st.sampled_from(places))
        word = draw(st.one_of(WORDS, st.just(''), st.just(place.group() + ' ' + place.group())))
        text = text[: place.start()] + word + text[place.end() :]
    return text


@settings(max_examples=60)
@given(text=changed_files())
def test_a_python_launch_file_with_mistakes_gives_a_plan_or_an_error(folder: Path, text: str) -> None:
    path = folder / 'changed.launch.py'
    path.write_text(text)
    planned(path)


PARAMETERS = b'/**:\n  ros__parameters:\n    background_r: 3\n    list: [1, 2]\n/ns/sim:\n  ros__parameters: {holonomic: true, a: {b: c}}\n'


@st.composite
def changed_parameters(draw: st.DrawFn) -> bytes:
    """The parameter file with a few pieces replaced."""
    data = PARAMETERS
    for _ in range(draw(st.integers(1, 4))):
        start = draw(st.integers(0, len(data)))
        stop = draw(st.integers(start, min(len(data), start + 12)))
        piece = draw(
            st.one_of(
                st.binary(max_size=4),
                st.sampled_from(
                    [
                        b'&a',
                        b'*a',
                        b'- ',
                        b': ',
                        b'\n',
                        b'  ',
                        b'\t',
                        b'[',
                        b'}',
                        b'!!python/object',
                        b'.nan',
                        b'1e999',
                        b'~',
                        b'<<: *a',
                        b'? ',
                        b'|\n',
                    ]
                ),
            )
        )
        data = data[:start] + piece + data[stop:]
    return data


@settings(max_examples=60)
@given(data=st.one_of(changed_parameters(), st.binary(max_size=60)))
def test_a_parameter_file_with_mistakes_gives_a_plan_or_an_error(folder: Path, data: bytes) -> None:
    (folder / 'p.yaml').write_bytes(data)
    path = folder / 'node.launch.py'
    path.write_text(
        'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n'
        'def generate_launch_description():\n    return LaunchDescription([Node(package="turtlesim", name="sim", '
        f'namespace="ns", executable="turtlesim_node", parameters=[{str(folder / "p.yaml")!r}])])\n'
    )
    planned(path)


def test_the_fuzzers_meet_plans_and_errors(folder: Path) -> None:
    (folder / 'good.launch.py').write_text(FILE)
    (folder / 'bad.launch.py').write_text(FILE.replace('executable=', 'excutable='))
    assert planned(folder / 'good.launch.py')['error'] is None
    assert 'executable' in planned(folder / 'bad.launch.py')['error']['text']
