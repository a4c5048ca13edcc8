"""The tree that `ros2 launch -p` prints."""

from __future__ import annotations

from launch import LaunchDescription, LaunchIntrospector
from launch.actions import DeclareLaunchArgument, EmitEvent, ExecuteProcess, LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.events import Shutdown
from launch.substitutions import LaunchConfiguration


def test_the_tree() -> None:
    process = ExecuteProcess(cmd=['a', ['b', LaunchConfiguration('c')]])
    description = LaunchDescription(
        [
            LogInfo(msg=['text', LaunchConfiguration('x')]),
            process,
            EmitEvent(event=Shutdown()),
            RegisterEventHandler(OnProcessExit(on_exit=[LogInfo(msg='x')])),
            DeclareLaunchArgument('x'),
        ]
    )
    assert LaunchIntrospector().format_launch_description(description).splitlines() == [
        '<launch.launch_description.LaunchDescription object at 0x>',
        "├── LogInfo('text' + LaunchConfig('x'))",
        "├── ExecuteProcess(cmd=['a', 'b' + LaunchConfig('c')], cwd=None, env=None, shell=False)",
        "├── EmitEvent(event='launch.events.Shutdown')",
        "├── RegisterEventHandler('<launch.event_handlers.on_process_exit.OnProcessExit object at 0x>'):",
        "│   └── OnProcessExit(matcher='event == ProcessExited', handler='<actions>', handle_once=False)",
        "│       └── LogInfo('x')",
        "└── Action('<launch.actions.declare_launch_argument.DeclareLaunchArgument object at 0x>')",
    ]
